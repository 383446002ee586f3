// Obstacles that are maps: grids of blocked cells, made into few boxes.
#pragma once

#include <string>
#include <vector>

#include "common/io/fields.h"
#include "common/io/scene_context.h"
#include "common/model/scene.h"

namespace accord {

// Appends the boxes of the map that `fields` (with key `map`) names, placed at `pose`: across the
// plane in planar scenes, from the plane of `pose` up to `height` in spatial ones. Each box is
// named after its cells. Reports faults and appends nothing then.
void read_map(const Fields& fields, const std::string& name, const Pose& pose,
              SceneContext& context, std::vector<Obstacle>& obstacles);

}  // namespace accord
