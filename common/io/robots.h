// The robots of a scene and their queries.
#pragma once

#include <vector>

#include "common/io/document.h"
#include "common/io/models.h"
#include "common/io/scene_context.h"
#include "common/model/robot.h"

namespace accord {

// A robot, and where its parts stand in the scene's file.
struct PlacedRobot {
  Robot robot;
  Value value;
  Value start;
  Value goal;
};

// Reads the list `robots`. Those at fault are reported and left out. `models` is null where the
// scene's models could not be read at all: then nobody is blamed for naming one.
std::vector<PlacedRobot> read_robots(const Value& list, const Models* models,
                                     SceneContext& context);

// "disk", "footprint", "ball" or "arm".
std::string_view kind_in_words(RobotKind kind);

}  // namespace accord
