#include "common/io/scene_file.h"

#include <optional>

#include "common/io/fields.h"
#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/models.h"
#include "common/io/obstacles.h"
#include "common/io/query_checks.h"
#include "common/io/robots.h"
#include "common/io/scene_context.h"
#include "common/io/words.h"
#include "common/io/yaml_reader.h"

namespace accord {
namespace {

constexpr std::string_view kVersion = "scene/1";

class SceneReader {
 public:
  // `name`: what the scene is called where it does not say.
  SceneReader(const std::string& file, const std::filesystem::path& folder, const FileSource& files,
              std::string name, Faults& faults)
      : file_(file), faults_(faults), context_{.faults = faults, .folder = folder, .files = files} {
    scene_.name = std::move(name);
  }

  std::shared_ptr<const Scene> read(std::string_view text) {
    if (text.size() > limits::kSceneBytes) {
      faults_.add(file_, 0, "",
                  "the scene is too large; expected at most " +
                      std::to_string(limits::kSceneBytes >> 20U) + " MiB");
      return nullptr;
    }
    const auto document = read_yaml(text, file_, limits::kSceneNodes, faults_);
    if (!document || !expect_map(document->root(), "a scene: a map of keys", faults_))
      return nullptr;
    const Fields fields(
        document->root(), "a scene",
        {"accord", "name", "timestep", "clearance", "environment", "models", "robots"}, faults_);
    if (!check_version(fields)) return nullptr;
    read_header(fields);
    read_environment(fields);
    const std::vector<PlacedRobot> robots = read_fleet(fields);
    auto scene = std::make_shared<const Scene>(std::move(scene_));
    // What is sound is checked even where other parts are not, so that one run finds all faults.
    if (context_.space != Space::kUnknown && !faults_.full()) check_starts_and_goals(scene, robots);
    return scene;
  }

 private:
  bool check_version(const Fields& fields) {
    const auto version = fields.require("accord", std::string(kVersion));
    if (!version) return true;  // reported; the rest may still tell something
    if (version->text() == kVersion) return true;
    fault_at(*version, "expected " + std::string(kVersion) + ", not " + version->in_words(),
             faults_);
    return false;
  }

  void read_header(const Fields& fields) {
    if (const auto value = fields.find("name")) {
      scene_.name = read_name(*value, faults_).value_or("");
    }
    if (const auto value = fields.find("timestep")) {
      constexpr Range kRange{limits::kMinTimestep, limits::kTimestep, "s"};
      scene_.timestep = read_number(*value, kRange, faults_).value_or(scene_.timestep);
    }
    if (const auto value = fields.find("clearance")) {
      constexpr Range kRange{0, limits::kSize, "m"};
      scene_.clearance = read_number(*value, kRange, faults_).value_or(0);
    }
  }

  void read_environment(const Fields& fields) {
    context_.space = Space::kSpatial;  // without bounds
    const auto environment = fields.find("environment");
    if (environment && !environment->is_null() &&
        expect_map(*environment, "a map of bounds and obstacles", faults_)) {
      const Fields inner(*environment, "an environment", {"bounds", "obstacles"}, faults_);
      if (const auto bounds = inner.find("bounds")) read_bounds(*bounds);
      if (const auto list = inner.find("obstacles")) {
        scene_.obstacles = read_obstacles(*list, context_);
      }
    }
    scene_.planar = context_.space == Space::kPlanar;
    scene_.bounds = context_.bounds;
  }

  void read_bounds(const Value& value) {
    context_.bounds_given = true;
    context_.space = Space::kUnknown;
    constexpr std::string_view kExpected = "[[x, y], [x, y]] or [[x, y, z], [x, y, z]]";
    if (!value.is_list() || value.size() != 2) {
      return fault_at(value,
                      "expected the least and the greatest corner, " + std::string(kExpected) +
                          ", not " + value.in_words(),
                      faults_);
    }
    const Value min_value = *value.begin();
    const Value max_value = *++value.begin();
    const auto min =
        read_numbers(min_value, {2, 3}, "[x, y] or [x, y, z]", kCoordinateRange, faults_);
    const auto max =
        read_numbers(max_value, {2, 3}, "[x, y] or [x, y, z]", kCoordinateRange, faults_);
    if (!min || !max) return;
    if (min->size() != max->size()) {
      return fault_at(
          max_value,
          "expected as many numbers as in the first corner, " + std::to_string(min->size()),
          faults_);
    }
    bool sound = true;
    for (std::size_t i = 0; i < min->size(); ++i) {
      if ((*max)[i] - (*min)[i] >= limits::kMinSize) continue;
      fault_at(value,
               std::string("the first corner's ") + "xyz"[i] + ", " + in_words((*min)[i]) +
                   ", must be less than the second's, " + in_words((*max)[i]),
               faults_);
      sound = false;
    }
    const bool planar = min->size() == 2;
    context_.space = planar ? Space::kPlanar : Space::kSpatial;
    if (!sound) return;
    context_.bounds = Bounds{{(*min)[0], (*min)[1], planar ? 0 : (*min)[2]},
                             {(*max)[0], (*max)[1], planar ? 0 : (*max)[2]}};
  }

  std::vector<PlacedRobot> read_fleet(const Fields& fields) {
    std::optional<Models> models;
    if (const auto map = fields.require("models", "a map of robot models")) {
      models = read_models(*map, context_);
    }
    const auto list = fields.require("robots", "a list of robots");
    if (!list) return {};
    std::vector<PlacedRobot> robots = read_robots(*list, models ? &*models : nullptr, context_);
    for (const PlacedRobot& placed : robots) {
      scene_.robots.push_back(placed.robot);
      if (context_.bounds_given || placed.robot.model->kind == RobotKind::kArm) continue;
      fault_at(placed.value,
               std::string(kind_in_words(placed.robot.model->kind)) + "s need " +
                   "environment.bounds: nothing else says where they may go",
               faults_);
    }
    return robots;
  }

  void check_starts_and_goals(const std::shared_ptr<const Scene>& scene,
                              const std::vector<PlacedRobot>& robots) {
    std::vector<QueryChecks> checks;
    for (const PlacedRobot& placed : robots) {
      checks.push_back({placed.start ? QueryCheck::kDue : QueryCheck::kNone,
                        placed.goal ? QueryCheck::kDue : QueryCheck::kNone});
    }
    check_queries(scene, checks, [&](RobotId robot, QuerySide side, std::string_view text) {
      const PlacedRobot& placed = robots[robot.index()];
      const auto& value = side == QuerySide::kStart ? placed.start : placed.goal;
      fault_at(value.value_or(placed.value), text, faults_);
      return !faults_.full();
    });
  }

  const std::string& file_;
  Faults& faults_;
  SceneContext context_;
  Scene scene_;
};

}  // namespace

SceneResult load_scene(const std::filesystem::path& path) {
  const auto text = read_file(path, limits::kSceneBytes);
  if (!text) return {nullptr, {{path.string(), 0, "", text.error()}}};
  const std::filesystem::path folder = path.parent_path();
  return parse_scene(*text, path.string(), folder.empty() ? "." : folder);
}

SceneResult parse_scene(std::string_view text, const std::string& file,
                        const std::filesystem::path& folder, const FileSource& files,
                        const std::string& name) {
  Faults faults(file);
  std::string unnamed = name.empty() ? std::filesystem::path(file).stem().string() : name;
  if (!is_name(unnamed)) unnamed = "scene";
  auto scene = SceneReader(file, folder, files, std::move(unnamed), faults).read(text);
  if (faults.count() > 0) scene = nullptr;
  return {std::move(scene), faults.take()};
}

}  // namespace accord
