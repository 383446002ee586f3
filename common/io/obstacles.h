// The obstacles of a scene.
#pragma once

#include <vector>

#include "common/io/document.h"
#include "common/io/scene_context.h"
#include "common/model/scene.h"

namespace accord {

// Reads environment.obstacles. Those at fault are reported and left out; a map becomes many.
std::vector<Obstacle> read_obstacles(const Value& list, SceneContext& context);

}  // namespace accord
