// The shortest way of one robot over a shared roadmap, other robots left aside.
#pragma once

#include <optional>
#include <vector>

#include "common/planning/subproblem.h"
#include "worker/shared_roadmap.h"

namespace accord {

// The shortest path (in time) from start to goal, as configurations from start to goal, numbers
// running on over whole turns; nullopt: none. A* with lazy proofs; start and goal are joined to
// their neighbours for this query alone. Requires: start and goal are free.
std::optional<std::vector<Configuration>> shortest_path(const SharedRoadmap& roadmap,
                                                        ConfigurationView start,
                                                        ConfigurationView goal, Effort& effort);

}  // namespace accord
