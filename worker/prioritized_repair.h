// Prioritized planning for larger teams, with repair instead of restarts: robots are planned one
// after the other around those already settled; one that finds no way goes through as few settled
// robots as it can, and these are planned anew. After the repair of MAPF-LNS2 (Li et al. 2022) and
// the priorities of Erdmann and Lozano-Perez (1987), in continuous space and time.
#pragma once

#include <atomic>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/decoupled_roadmaps.h"

namespace accord {

// Plans the whole team on the given roadmaps within what subproblem.limits allows. Not solved when
// a robot has no way even past nobody but the outsiders, or the limits are reached. `effort` is
// increased by what it cost.
Resolution prioritized_repair(const CollisionWorld& world, const Subproblem& subproblem,
                              DecoupledRoadmaps& roadmaps, const std::atomic<bool>& stop,
                              Effort& effort);

}  // namespace accord
