// What a robot does after its local path: goes on along its tail, or rests at its final goal.
#pragma once

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"

namespace accord {

// The local path with the task's tail behind it. Requires: the path ends at the task's goal.
Trajectory with_tail(const CollisionWorld& world, const Task& task, const Trajectory& local);

// How long a robot must be able to rest at its goal: until the horizon where its path ends there,
// no time at all where it goes on.
double hold_until(const Subproblem& subproblem, const Task& task);

}  // namespace accord
