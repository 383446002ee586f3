// A guess at who will have to be planned together: robots are taken to meet where the boxes of
// their straight ways have most in common. Quick rather than right: it decides who gets what, never
// what comes back.
#pragma once

#include <vector>

#include "common/geometry/collision_world.h"
#include "coordinator/dispatch/warm_roadmaps.h"

namespace accord {

// places: by robot (common/model/roadmap_places.h). Thread safe.
RoadmapPartners roadmap_partners(const CollisionWorld& world,
                                 const std::vector<RoadmapPlace>& places);

}  // namespace accord
