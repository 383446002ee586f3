// accord info: what is in a scene.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "client/commands.h"
#include "client/counted.h"
#include "client/files.h"
#include "client/table.h"
#include "common/model/robot.h"

namespace accord {
namespace {

std::string kind_name(RobotKind kind) {
  switch (kind) {
    case RobotKind::kDisk:
      return "disk";
    case RobotKind::kFootprint:
      return "footprint";
    case RobotKind::kBall:
      return "ball";
    case RobotKind::kArm:
      return "arm";
  }
  return "robot";
}

std::string bounds_text(const Scene& scene) {
  if (!scene.bounds) return "none";
  const Vec3 size = scene.bounds->max - scene.bounds->min;
  return scene.planar ? fmt::format("{:g} x {:g} m", size.x(), size.y())
                      : fmt::format("{:g} x {:g} x {:g} m", size.x(), size.y(), size.z());
}

// "25 boxes", or of several kinds "2 boxes, 1 sphere".
std::string obstacles_text(const Scene& scene) {
  static const std::vector<std::pair<std::string, std::string>> kNames = {
      {"sphere", "spheres"}, {"capsule", "capsules"}, {"cylinder", "cylinders"},
      {"box", "boxes"},      {"polygon", "polygons"}, {"mesh", "meshes"}};
  std::vector<std::size_t> counts(std::variant_size_v<Shape>);
  for (const Obstacle& obstacle : scene.obstacles) ++counts[obstacle.shape.index()];
  std::string out;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    if (!out.empty()) out += ", ";
    out += fmt::format("{} {}", counts[i], counts[i] == 1 ? kNames[i].first : kNames[i].second);
  }
  return out.empty() ? "none" : out;
}

void add_models(Table& table, const Scene& scene) {
  std::map<std::string, std::pair<const RobotModel*, std::size_t>> models;
  for (const Robot& robot : scene.robots) {
    auto& [model, count] = models[robot.model->name];
    model = robot.model.get();
    ++count;
  }
  for (const auto& [name, used] : models) {
    const auto& [model, count] = used;
    table.add("  " + name, fmt::format("{}, each {} with {} and {}", count, kind_name(model->kind),
                                       counted(model->dof(), "degree") + " of freedom",
                                       counted(model->bodies.size(), "body part")));
  }
}

// What no plan can do better than: every robot straight to its goal, as if it were alone in empty
// space.
void add_lower_bounds(Table& table, const Scene& scene) {
  double makespan = 0;
  double sum = 0;
  for (const Robot& robot : scene.robots) {
    std::vector<double> delta(robot.model->dof());
    difference(*robot.model, robot.start, robot.goal, delta);
    const double duration = least_duration(*robot.model, delta);
    makespan = std::max(makespan, duration);
    sum += duration;
  }
  table.add("at least", fmt::format("makespan {:.2f} s, sum of costs {:.2f} s (straight lines)",
                                    makespan, sum));
}

ExitCode run(const std::string& path) {
  const std::shared_ptr<const Scene> scene = load_scene_or_explain(path);
  if (!scene) return ExitCode::kBadInput;
  Table table;
  table.add("scene", scene->name + (scene->planar ? ", planar" : ", spatial"));
  table.add("bounds", bounds_text(*scene));
  table.add("obstacles", obstacles_text(*scene));
  table.add("clearance", fmt::format("{:g} m", scene->clearance));
  table.add("timestep", fmt::format("{:g} s", scene->timestep));
  std::size_t dof = 0;
  for (const Robot& robot : scene->robots) dof += robot.model->dof();
  table.add("robots", fmt::format("{} with {} of freedom together", scene->robots.size(),
                                  counted(dof, "degree")));
  add_models(table, *scene);
  add_lower_bounds(table, *scene);
  std::cout << table.str();
  return ExitCode::kSuccess;
}

}  // namespace

void add_info_command(CLI::App& app, ExitCode& exit_code) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("info", "Say what is in a scene");
  command->add_option("SCENE", *path, "Scene file (.yaml)")->required();
  command->callback([path, &exit_code] { exit_code = run(*path); });
}

}  // namespace accord
