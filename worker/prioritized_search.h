// Prioritized planning on given roadmaps: robots in an order, each with the ones before it and the
// outsiders as moving obstacles (Erdmann and Lozano-Perez 1987), several orders tried.
#pragma once

#include <atomic>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/decoupled_roadmaps.h"

namespace accord {

// In task order where subproblem.limits allows one order only; else of two robots the order with
// the least sum of arrivals, of more the first that works, within what the limits allow. Local
// paths are shortened before they are returned. Not solved when no order works.
Resolution prioritized_search(const CollisionWorld& world, const Subproblem& subproblem,
                              DecoupledRoadmaps& roadmaps, const std::atomic<bool>& stop);

}  // namespace accord
