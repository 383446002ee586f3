// Obstacles that are maps: grids of blocked cells, made into few boxes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/io/fields.h"
#include "common/io/scene_context.h"
#include "common/model/scene.h"

namespace accord {

// Appends the boxes of the map that `fields` (with key `map`) names, placed at `pose`: across the
// plane in planar scenes; in spatial ones from the plane of `pose` up to `height`, or through all
// of the scene's bounds where none is given. Each box is named after its cells. Appends nothing
// where there is a fault, which is reported, or no `pose`, whose fault was.
void read_map(const Fields& fields, const std::string& name, const std::optional<Pose>& pose,
              SceneContext& context, std::vector<Obstacle>& obstacles);

}  // namespace accord
