// The robot models of a scene.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "common/io/document.h"
#include "common/io/scene_context.h"
#include "common/model/robot.h"

namespace accord {

// The models by name; null for those at fault, so that robots that name them are not blamed too.
using Models = std::map<std::string, std::shared_ptr<const RobotModel>, std::less<>>;

// Reads the map `models`. Reports what is at fault; nullopt where it is no map.
std::optional<Models> read_models(const Value& map, SceneContext& context);

}  // namespace accord
