// Prioritized planning on given roadmaps: robots in an order, each with the ones before it and the
// outsiders as moving obstacles (Erdmann and Lozano-Perez 1987), several orders tried.
#pragma once

#include <atomic>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/decoupled_roadmaps.h"

namespace accord {

// Of two robots the order with the least sum of arrivals, of more the first that works, within what
// subproblem.limits allows. Local paths are shortened before they are returned. Not solved when no
// order works.
Resolution prioritized_search(const CollisionWorld& world, const Subproblem& subproblem,
                              DecoupledRoadmaps& roadmaps, const std::atomic<bool>& stop);

}  // namespace accord
