// A scene as workers need it: what their roadmaps, which they keep for requests to come, depend on,
// and no more. A request for other starts and goals of a cell's arms then finds them warm.
// Pure; thread safe.
#pragma once

#include "common/model/scene.h"

namespace accord {

// The scene with arms at a place that depends on their models alone: where an arm starts and what
// it is to reach, subproblems say. Mobile robots' starts and goals stay: their roadmaps have ways
// around them (worker/robot_roadmap.h).
Scene scene_for_workers(const Scene& scene);

}  // namespace accord
