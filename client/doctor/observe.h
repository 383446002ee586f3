// Looks at this machine and at the domain, for as long as it takes.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "client/doctor/observations.h"

namespace accord {

// Ends when more listening would say no more, when `patience` has passed, or soon after `stop`.
Observations observe(const DdsOptions& options, const std::string& version,
                     std::chrono::nanoseconds patience, const std::atomic<bool>& stop);

}  // namespace accord
