// The two ends of the public topics over DDS (Fast DDS 2.9). Topics, quality of service and the
// order of events: docs/topics.md.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "common/transport/dds_options.h"
#include "common/transport/fleet/fleet_port.h"
#include "common/transport/ros/ros_options.h"

namespace accord {

// Both join a domain, or say in a sentence why they could not, which takes some milliseconds; the
// other end is found mostly within 0.3 s. Each is a DDS participant of its own, which the bus of
// the same cluster knows nothing of.

// `wake` is called, from any thread and until the port is destroyed, when take() may give
// something. It must not call the port, nor wait for a lock that is held while the port is called.
tl::expected<std::unique_ptr<FleetServicePort>, std::string> make_dds_fleet_service(
    const DdsOptions& options, std::function<void()> wake, const RosOptions& ros = {});

// Asks by itself, while take() and wait() are called, for whole plans that come with a gap. Without
// those, nothing of the paths travels to it, and it sends no PlanRequest.
tl::expected<std::unique_ptr<FleetClientPort>, std::string> make_dds_fleet_client(
    const DdsOptions& options, HeardPlans plans = HeardPlans::kWhole);

}  // namespace accord
