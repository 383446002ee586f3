// Maps of ROS's map_server: a YAML file that names a graymap and says how to read it.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "common/io/diagnostic.h"
#include "common/io/file_source.h"
#include "common/io/grid.h"
#include "common/model/shape.h"

namespace accord {

struct RosMap {
  Grid grid;
  double resolution;  // m a cell
  Pose origin;        // of the lower left corner of the grid
};

// A cell is free where its occupancy is below free_thresh; all others are blocked, and in mode
// trinary so are those of occupancy 50/255 exactly, which is how map savers write unknown ones (205
// of 255). Occupancy is (white - value) / white, or value / white where `negate`. Keys: image,
// resolution, origin [x, y, yaw]; and with defaults negate (0), occupied_thresh (0.65), free_thresh
// (0.196), mode (trinary or scale). `path` is the YAML file, whose text is given; the image lies in
// `files`. Thread safe.
std::optional<RosMap> parse_ros_map(std::string_view text, const std::filesystem::path& path,
                                    const FileSource& files, Faults& faults);

}  // namespace accord
