#include "client/render/drawn_robot.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "client/render/outline.h"
#include "client/render/palette.h"

namespace accord {
namespace {

constexpr double kCurveStep = 0.05;  // rad: how finely the ways of arms are drawn

}  // namespace

std::vector<DrawnRobot> drawn_robots(const Scene& scene, const Plan* plan) {
  std::unordered_map<std::string_view, const Trajectory*> paths;
  if (plan != nullptr) {
    for (const RobotPlan& robot : plan->robots) paths.emplace(robot.name, &robot.trajectory);
  }
  std::vector<DrawnRobot> out;
  for (const Robot& robot : scene.robots) {
    const auto path = paths.find(robot.name);
    const bool fits =
        path != paths.end() && !path->second->empty() && path->second->dof() == robot.model->dof();
    out.push_back({robot, fits ? path->second : nullptr, robot_colour(out.size())});
  }
  return out;
}

std::vector<Vec3> traced_way(const DrawnRobot& drawn) {
  std::vector<Vec3> way;
  const Trajectory& path = *drawn.path;
  way.push_back(traced_point(drawn.robot, path.configuration(0)));
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    double turn = 0;
    for (std::size_t k = 0; k < path.dof(); ++k) {
      turn = std::max(turn, std::abs(path.configuration(i + 1)[k] - path.configuration(i)[k]));
    }
    const bool curved = drawn.robot.model->kind == RobotKind::kArm;
    const int steps = curved ? std::max(1, static_cast<int>(std::ceil(turn / kCurveStep))) : 1;
    for (int s = 1; s <= steps; ++s) {
      const double t = path.time(i) + (path.time(i + 1) - path.time(i)) * s / steps;
      way.push_back(traced_point(drawn.robot, path.at(t)));
    }
  }
  return way;
}

}  // namespace accord
