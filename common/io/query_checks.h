// Whether robots can stand where their queries begin and end.
#pragma once

#include <memory>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/io/robots.h"
#include "common/model/scene.h"

namespace accord {

// Room beyond the clearance that starts and goals must keep: more than planning does
// (kPlanningMargin), so that every query that is accepted here can be planned.
inline constexpr double kQueryMargin = 2e-6;  // m

// Reports starts and goals that leave the bounds, touch obstacles or the robot itself, or come too
// close to another robot's. robots[i] tells where scene.robots[i] stands in the file, and which of
// its start and goal there are to check.
void check_queries(std::shared_ptr<const Scene> scene, const std::vector<PlacedRobot>& robots,
                   Faults& faults);

}  // namespace accord
