#include "common/io/map_obstacle.h"

#include <optional>

#include "common/io/files.h"
#include "common/io/grid.h"
#include "common/io/movingai_map.h"
#include "common/io/ros_map.h"
#include "common/io/words.h"

namespace accord {
namespace {

struct Map {
  Grid grid;
  double cell;  // m
  Pose origin;  // of the lower left corner
};

std::optional<Map> load_map(const Fields& fields, SceneContext& context) {
  const Value value = *fields.find("map");
  const auto path = context.file_of(value);
  if (!path) return std::nullopt;
  const std::string extension = extension_of(*path);
  const bool ros = extension == ".yaml" || extension == ".yml";
  if (!ros && extension != ".map") {
    fault_at(value,
             "expected a map that ends in .map (MovingAI) or .yaml (ROS), not " +
                 in_quotes(value.text()),
             context.faults);
    return std::nullopt;
  }
  std::optional<double> cell = 1;
  if (const auto given = fields.find("cell")) {
    cell = read_number(*given, kSizeRange, context.faults);
    if (ros) fault_at(*given, "a ROS map has its own resolution; leave cell out", context.faults);
  }
  const auto text = context.files.read(*path, limits::kMapBytes);
  if (!text) {
    fault_at(value, text.error(), context.faults);
    return std::nullopt;
  }
  if (ros) {
    auto map = parse_ros_map(*text, *path, context.files, context.faults);
    if (!map) return std::nullopt;
    return Map{std::move(map->grid), map->resolution, map->origin};
  }
  auto grid = parse_movingai_map(*text, path->string(), context.faults);
  if (!grid || !cell) return std::nullopt;
  return Map{std::move(*grid), *cell, Pose::Identity()};
}

// From where to where the boxes reach along the map's z, 0 being the map's plane.
struct Extent {
  double low;
  double high;
};

// The least extent that holds all of the bounds, wherever the map lies and however it is tilted.
Extent extent_of(const Bounds& bounds, const Pose& pose) {
  const Vec3 z = pose.linear().col(2);
  const Vec3 low = (bounds.min - pose.translation()).cwiseProduct(z);
  const Vec3 high = (bounds.max - pose.translation()).cwiseProduct(z);
  return {low.cwiseMin(high).sum(), low.cwiseMax(high).sum()};
}

// Without a height, walls leave no room above or below them.
std::optional<Extent> spatial_extent(const Fields& fields, const Pose& pose,
                                     SceneContext& context) {
  if (const auto given = fields.find("height")) {
    const auto height = read_number(*given, kSizeRange, context.faults);
    return height ? std::optional<Extent>({0, *height}) : std::nullopt;
  }
  if (!context.bounds) {
    if (!context.bounds_given) {
      fields.require("height",
                     "how far the walls of the map rise, in m, or environment.bounds to fill");
    }
    return std::nullopt;
  }
  const Extent extent = extent_of(*context.bounds, pose);
  if (extent.high - extent.low <= limits::kSize) return extent;
  fault_at(fields.map(), "height",
           "the bounds are " + in_words(extent.high - extent.low) +
               " m high, too much to fill; expected a height of at most " +
               in_words(limits::kSize) + " m",
           context.faults);
  return std::nullopt;
}

std::optional<Extent> extent_of(const Fields& fields, double cell, const Pose& pose,
                                SceneContext& context) {
  if (context.space == Space::kSpatial) return spatial_extent(fields, pose, context);
  const auto given = fields.find("height");
  if (given && context.space == Space::kPlanar) {
    fault_at(*given, "a map has no height in a planar scene", context.faults);
  }
  return Extent{-cell / 2, cell / 2};
}

Obstacle to_obstacle(const CellBlock& block, const Map& map, const Extent& extent,
                     const std::string& name, const Pose& pose) {
  const auto metres = [&](std::size_t cells) { return static_cast<double>(cells) * map.cell; };
  const Vec3 low(metres(block.first_column), metres(block.first_row), extent.low);
  const Vec3 high(metres(block.last_column + 1), metres(block.last_row + 1), extent.high);
  Pose placed = pose * map.origin;
  placed.translation() = placed * ((low + high) / 2).eval();
  return {name + " x " + std::to_string(block.first_column) + "-" +
              std::to_string(block.last_column) + " y " + std::to_string(block.first_row) + "-" +
              std::to_string(block.last_row),
          Box{high - low}, placed};
}

}  // namespace

void read_map(const Fields& fields, const std::string& name, const std::optional<Pose>& pose,
              SceneContext& context, std::vector<Obstacle>& obstacles) {
  const auto map = load_map(fields, context);
  const auto extent =
      extent_of(fields, map ? map->cell : 1, pose.value_or(Pose::Identity()), context);
  if (!map || !extent || !pose) return;
  const Value value = *fields.find("map");
  const double side = static_cast<double>(std::max(map->grid.width, map->grid.height)) * map->cell;
  if (side > limits::kSize) {
    fault_at(
        value,
        "a map of " + in_words(side) + " m; expected at most " + in_words(limits::kSize) + " m",
        context.faults);
    return;
  }
  const auto blocks = cover(map->grid, limits::kObstacles - obstacles.size());
  if (!blocks) {
    fault_at(value,
             "the scene needs more than " + std::to_string(limits::kObstacles) +
                 " obstacles; use a coarser map",
             context.faults);
    return;
  }
  obstacles.reserve(obstacles.size() + blocks->size());
  for (const CellBlock& block : *blocks) {
    obstacles.push_back(to_obstacle(block, *map, *extent, name, *pose));
  }
}

}  // namespace accord
