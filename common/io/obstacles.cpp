#include "common/io/obstacles.h"

#include <array>
#include <string>
#include <string_view>

#include "common/geometry/planar_cut.h"
#include "common/io/fields.h"
#include "common/io/limits.h"
#include "common/io/map_obstacle.h"
#include "common/io/shape_fields.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr std::array<std::string_view, 6> kKinds = {"box",     "sphere", "cylinder",
                                                    "polygon", "mesh",   "map"};

std::vector<std::string_view> keys_of(std::string_view kind) {
  std::vector<std::string_view> keys{kind, "at", "rpy", "name"};
  if (kind == "mesh") keys.push_back("scale");
  if (kind == "map") keys.insert(keys.end(), {"cell", "height"});
  return keys;
}

void read_obstacle(const Value& value, std::size_t number, SceneContext& context,
                   std::vector<Obstacle>& obstacles) {
  if (!expect_map(value, "an obstacle, such as {box: [1, 1, 1]}", context.faults)) return;
  const std::string_view kind = only_kind_of(value, kKinds, "shape", context.faults);
  if (kind.empty()) return;
  const Fields fields(value, "a " + std::string(kind) + " obstacle", keys_of(kind), context.faults);
  std::string name = "obstacle " + std::to_string(number) + " (" + std::string(kind) + ")";
  if (const auto given = fields.find("name")) {
    name = read_name(*given, context.faults).value_or(name);
  }
  const auto pose = read_pose(fields, context.space, context.faults);
  if (kind == "map") {
    if (context.space == Space::kPlanar && pose && pose->translation().z() != 0) {
      fault_at(*fields.find("at"), "a map lies in the plane z = 0 of a planar scene",
               context.faults);
    }
    return read_map(fields, name, pose, context, obstacles);
  }
  const auto shape = read_shape(fields, kind, context);
  const auto blame = [&](std::string_view text) { fault_at(value, text, context.faults); };
  if (!shape || !context.afford(*shape, blame) || !pose) return;
  if (context.space == Space::kPlanar) {
    if (const auto cut = planar_cut(*shape, *pose); !cut) {
      return blame(in_quotes(name) + " " + cut.error());
    }
  }
  obstacles.push_back({std::move(name), *shape, *pose});
}

}  // namespace

std::vector<Obstacle> read_obstacles(const Value& list, SceneContext& context) {
  std::vector<Obstacle> obstacles;
  if (list.is_null() || !expect_list(list, "obstacles", context.faults)) return obstacles;
  std::size_t number = 0;
  for (const Value value : list) {
    if (obstacles.size() >= limits::kObstacles) {
      fault_at(list, "more than " + std::to_string(limits::kObstacles) + " obstacles",
               context.faults);
      break;
    }
    if (context.faults.full()) break;
    read_obstacle(value, number++, context, obstacles);
  }
  return obstacles;
}

}  // namespace accord
