// The Bus over DDS (Fast DDS 2.9). What was chosen, and why: docs/architecture.md.
#pragma once

#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "common/transport/bus.h"
#include "common/transport/dds_options.h"

namespace accord {

// Joins a domain, or says in a sentence why it could not. Takes some milliseconds; peers appear
// when discovery has found them, mostly within 0.3 s.
tl::expected<std::unique_ptr<Bus>, std::string> make_dds_bus(Role role, const DdsOptions& options);

}  // namespace accord
