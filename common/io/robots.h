// The robots of a scene and their queries.
#pragma once

#include <optional>
#include <string_view>
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
  std::optional<Value> start;  // nullopt where it is missing or at fault: robot.start is no place
  std::optional<Value> goal;   // likewise
};

// Reads the list `robots` and reports what is at fault. Left out are only robots of which nothing
// more can be checked, as their model or their place is not known; others are there with whatever
// is sound about them. `models` is null where the scene's models could not be read at all: then
// nobody is blamed for naming one.
std::vector<PlacedRobot> read_robots(const Value& list, const Models* models,
                                     SceneContext& context);

// "disk", "footprint", "ball" or "arm".
std::string_view kind_in_words(RobotKind kind);

}  // namespace accord
