// The shapes of obstacles as the scene file says them; all but maps.
#pragma once

#include <optional>
#include <string_view>

#include "common/io/fields.h"
#include "common/io/scene_context.h"
#include "common/model/shape.h"

namespace accord {

// `kind` is one of box, sphere, cylinder, polygon, mesh, and a key of `fields`.
std::optional<Shape> read_shape(const Fields& fields, std::string_view kind, SceneContext& context);

}  // namespace accord
