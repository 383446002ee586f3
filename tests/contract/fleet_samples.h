// Requests, news and plans for tests of the public topics, with something in every field.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/transport/fleet/fleet_messages.h"

namespace accord::fleet_samples {

std::vector<FleetRequest> requests();

// All but plans.
std::vector<FleetNews> news();

// Of so many robots with so many waypoints of three numbers; their segments name crowds. Numbers
// have all their bits in use.
FinishedPlan plan_of(const std::string& id, std::size_t robots, std::size_t waypoints);

// Every bit of a plan: equal for equal plans only.
std::string bits_of(const Plan& plan);

}  // namespace accord::fleet_samples
