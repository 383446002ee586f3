// Free configurations of one robot, spread over its whole configuration space and, where it is
// narrow, into the passages. The same for every process: they depend on scene and count alone.
#pragma once

#include <vector>

#include "common/geometry/collision_world.h"

namespace accord {

// At most `count` free configurations: Halton points that are free, and bridges (Hsu et al. 2003)
// across the blocked ones: middles of two blocked configurations, which lie in narrow passages.
// Requires: mobile robots have scene bounds.
std::vector<Configuration> free_samples(const CollisionWorld& world, RobotId robot,
                                        std::size_t count);

}  // namespace accord
