// What every process says of itself on /metrics: its version, since when it runs, and what it takes
// of the machine. The names are those that programs everywhere use.
#pragma once

#include <string>

#include "common/runtime/metrics.h"

namespace accord {

// Adds them, read off the system whenever they are asked for.
void add_process_metrics(Metrics& metrics, const std::string& version);

}  // namespace accord
