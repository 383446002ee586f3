// After a composite solution: lets each robot move at its own pace. In the composite space all
// robots depart and arrive together, so that everyone is as slow as the slowest.
#pragma once

#include <atomic>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"

namespace accord {

// Plans each robot's local path again along its own places, the others' paths standing, and keeps
// what arrives earlier. The resolution stays free throughout. Requires: resolution.solved.
void uncouple(const CollisionWorld& world, const Subproblem& subproblem, Resolution& resolution,
              const std::atomic<bool>& stop);

}  // namespace accord
