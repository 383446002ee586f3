// What the main() of a service has around its work.
#pragma once

#include <functional>

#include "common/runtime/process_exit.h"

namespace accord {

// What run() comes to, as main() returns it. Whatever it throws is a bug, or a lack of memory: that
// is said on stderr.
int process_main(const char* program, const std::function<ProcessExit()>& run);

}  // namespace accord
