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

// How the YAML file says that values of the graymap are to be read.
struct Reading {
  bool negate = false;
  bool trinary = true;
  double occupied = 0.65;
  double free = 0.196;
};

// Whether a cell is one that nobody has looked at. Map savers of ROS write those as 205 of 255, and
// reading with it that do not always tell: at nav2's free_thresh of 0.25 its occupancy of 0.196
// would be free.
bool is_unknown(unsigned whiteness, unsigned white) {
  return whiteness * 255 == white * 205;
}

bool is_blocked(unsigned value, unsigned white, const Reading& reading) {
  const unsigned whiteness = reading.negate ? white - value : value;
  if (reading.trinary && is_unknown(whiteness, white)) return true;
  const double occupancy = static_cast<double>(white - whiteness) / white;
  return occupancy >= reading.free;
}

Grid to_grid(const Graymap& map, const Reading& reading) {
  Grid grid{map.width, map.height, std::vector<std::uint8_t>(map.values.size())};
  for (std::size_t row = 0; row < map.height; ++row) {
    for (std::size_t column = 0; column < map.width; ++column) {
      const unsigned value = map.values[row * map.width + column];
      const std::size_t y = map.height - 1 - row;
      grid.blocked[y * map.width + column] = is_blocked(value, map.max_value, reading) ? 1 : 0;
    }
  }
  return grid;
}

std::optional<Grid> read_image(const Value& image, const FileSource& files,
                               const std::filesystem::path& folder, const Reading& reading,
                               Faults& faults) {
  const auto name = read_name(image, faults);
  if (!name) return std::nullopt;
  const auto path = resolve(*name, folder);
  const auto bytes = path ? files.read(*path, limits::kMapBytes) : tl::unexpected(path.error());
  if (!bytes) {
    fault_at(image, bytes.error(), faults);
    return std::nullopt;
  }
  const auto map = parse_pgm(
      *bytes, path->string(), [&](auto why) { fault_at(image, why, faults); }, faults);
  if (!map) return std::nullopt;
  return to_grid(*map, reading);
}

// Reports into faults; what is at fault keeps its default.
Reading read_reading(const Fields& fields, Faults& faults) {
  Reading reading;
  if (const auto value = fields.find("negate")) {
    reading.negate = read_flag(*value, faults).value_or(false);
  }
  if (const auto value = fields.find("occupied_thresh")) {
    reading.occupied = read_number(*value, kThreshold, faults).value_or(1);
  }
  if (const auto value = fields.find("free_thresh")) {
    reading.free = read_number(*value, kThreshold, faults).value_or(0);
    if (reading.free > reading.occupied) {
      fault_at(*value, "must not be above occupied_thresh, " + in_words(reading.occupied), faults);
    }
  }
  const auto mode = fields.find("mode");
  if (mode && mode->text() != "trinary" && mode->text() != "scale") {
    fault_at(*mode, "expected trinary or scale, not " + mode->in_words(), faults);
  }
  reading.trinary = !mode || mode->text() == "trinary";
  return reading;
}

}  // namespace

std::optional<RosMap> parse_ros_map(std::string_view text, const std::filesystem::path& path,
                                    const FileSource& files, Faults& faults) {
  const std::size_t before = faults.count();
  const auto document = read_yaml(text, path.string(), kMapValues, faults);
  if (!document || !expect_map(document->root(), "a map_server map", faults)) return std::nullopt;
  const Fields fields(
      document->root(), "a map_server map",
      {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"},
      faults);
  const Reading reading = read_reading(fields, faults);
  RosMap map;
  if (const auto value = fields.require("resolution", "the size of a cell in m")) {
    map.resolution = read_number(*value, kSizeRange, faults).value_or(1);
  }
  if (const auto value = fields.require("origin", "[x, y, yaw]")) {
    const auto origin = read_numbers(*value, {3}, "[x, y, yaw]", kCoordinateRange, faults);
    if (origin) map.origin = make_pose({(*origin)[0], (*origin)[1], 0}, {0, 0, (*origin)[2]});
  }
  if (const auto image = fields.require("image", "the name of a pgm file")) {
    auto grid = read_image(*image, files, path.parent_path(), reading, faults);
    if (grid) map.grid = std::move(*grid);
  }
  if (faults.count() != before) return std::nullopt;
  return map;
}

}  // namespace accord
