// The models of mobile robots: disk, footprint, ball.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/io/document.h"
#include "common/io/scene_context.h"
#include "common/model/robot.h"

namespace accord {

// `kind` is one of disk, footprint, ball, and a key of `value`. Reports faults.
std::optional<RobotModel> read_mobile_model(const Value& value, std::string_view kind,
                                            SceneContext& context);

}  // namespace accord
