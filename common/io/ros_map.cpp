#include "common/io/ros_map.h"

#include "common/io/fields.h"
#include "common/io/files.h"
#include "common/io/pgm.h"
#include "common/io/pose_fields.h"
#include "common/io/words.h"
#include "common/io/yaml_reader.h"

namespace accord {
namespace {

constexpr std::size_t kMapValues = 10'000;  // keys and values of the YAML file

constexpr Range kThreshold{0, 1, ""};

struct Thresholds {
  bool negate = false;
  double occupied = 0.65;
  double free = 0.196;
};

Grid to_grid(const Graymap& map, const Thresholds& thresholds) {
  Grid grid{map.width, map.height, std::vector<std::uint8_t>(map.values.size())};
  for (std::size_t row = 0; row < map.height; ++row) {
    for (std::size_t column = 0; column < map.width; ++column) {
      const double value = map.values[row * map.width + column];
      const double white = map.max_value;
      const double occupancy = (thresholds.negate ? value : white - value) / white;
      const std::size_t y = map.height - 1 - row;
      grid.blocked[y * map.width + column] = occupancy < thresholds.free ? 0 : 1;
    }
  }
  return grid;
}

std::optional<Grid> read_image(const Value& image, const std::filesystem::path& folder,
                               const Thresholds& thresholds, Faults& faults) {
  const auto name = read_name(image, faults);
  if (!name) return std::nullopt;
  const auto path = resolve(*name, folder);
  const auto bytes = path ? read_file(*path, limits::kMapBytes) : tl::unexpected(path.error());
  if (!bytes) {
    fault_at(image, bytes.error(), faults);
    return std::nullopt;
  }
  const auto map = parse_pgm(*bytes, path->string(), faults);
  if (!map) return std::nullopt;
  return to_grid(*map, thresholds);
}

// Reports into faults; what is at fault keeps its default.
Thresholds read_thresholds(const Fields& fields, Faults& faults) {
  Thresholds thresholds;
  if (const auto value = fields.find("negate")) {
    thresholds.negate = read_flag(*value, faults).value_or(false);
  }
  if (const auto value = fields.find("occupied_thresh")) {
    thresholds.occupied = read_number(*value, kThreshold, faults).value_or(1);
  }
  if (const auto value = fields.find("free_thresh")) {
    thresholds.free = read_number(*value, kThreshold, faults).value_or(0);
    if (thresholds.free > thresholds.occupied) {
      fault_at(*value, "must not be above occupied_thresh, " + in_words(thresholds.occupied),
               faults);
    }
  }
  const auto mode = fields.find("mode");
  if (mode && mode->text() != "trinary" && mode->text() != "scale") {
    fault_at(*mode, "expected trinary or scale, not " + mode->in_words(), faults);
  }
  return thresholds;
}

}  // namespace

std::optional<RosMap> parse_ros_map(std::string_view text, const std::filesystem::path& path,
                                    Faults& faults) {
  const std::size_t before = faults.count();
  const auto document = read_yaml(text, path.string(), kMapValues, faults);
  if (!document || !expect_map(document->root(), "a map_server map", faults)) return std::nullopt;
  const Fields fields(
      document->root(), "a map_server map",
      {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"},
      faults);
  const Thresholds thresholds = read_thresholds(fields, faults);
  RosMap map;
  if (const auto value = fields.require("resolution", "the size of a cell in m")) {
    map.resolution = read_number(*value, kSizeRange, faults).value_or(1);
  }
  if (const auto value = fields.require("origin", "[x, y, yaw]")) {
    const auto origin = read_numbers(*value, {3}, "[x, y, yaw]", kCoordinateRange, faults);
    if (origin) map.origin = make_pose({(*origin)[0], (*origin)[1], 0}, {0, 0, (*origin)[2]});
  }
  if (const auto image = fields.require("image", "the name of a pgm file")) {
    auto grid = read_image(*image, path.parent_path(), thresholds, faults);
    if (grid) map.grid = std::move(*grid);
  }
  if (faults.count() != before) return std::nullopt;
  return map;
}

}  // namespace accord
