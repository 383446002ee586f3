// How a line of the log is written. For log.cpp and its tests: it needs spdlog's headers.
#pragma once

#include <spdlog/formatter.h>

#include <memory>

#include "common/runtime/log.h"

namespace accord {

// Whatever a message or a field holds, a record is one line, of valid UTF-8: control characters are
// escaped, what is no UTF-8 is escaped or replaced. Fields are those of the thread that logs, so
// sinks have to be synchronous.
std::unique_ptr<spdlog::formatter> make_log_formatter(LogFormat format);

}  // namespace accord
