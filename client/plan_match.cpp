#include "client/plan_match.h"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>

#include "client/counted.h"
#include "common/io/words.h"

namespace accord {

std::optional<std::string> other_scene(const Scene& scene, const Plan& plan) {
  if (plan.scene == scene.name) return std::nullopt;
  return fmt::format("the plan was made for scene {}; this is {}", in_quotes(plan.scene),
                     in_quotes(scene.name));
}

std::optional<std::string> other_robots(const Scene& scene, const Plan& plan) {
  if (plan.status != PlanStatus::kSolved && plan.robots.empty()) return std::nullopt;
  std::unordered_map<std::string_view, const Trajectory*> paths;
  for (const RobotPlan& robot : plan.robots) paths.emplace(robot.name, &robot.trajectory);
  for (const Robot& robot : scene.robots) {
    const auto found = paths.find(robot.name);
    if (found == paths.end()) return fmt::format("it has no robot {}", in_quotes(robot.name));
    const Trajectory& path = *found->second;
    if (path.empty() || path.dof() != robot.model->dof()) {
      return fmt::format("it moves robot {} in {}; the scene has {} of freedom for it",
                         in_quotes(robot.name), counted(path.dof(), "number"),
                         counted(robot.model->dof(), "degree"));
    }
    paths.erase(found);
  }
  if (paths.empty()) return std::nullopt;
  for (const RobotPlan& robot : plan.robots) {
    if (paths.contains(robot.name)) {
      return fmt::format("the scene has no robot {}", in_quotes(robot.name));
    }
  }
  return std::nullopt;
}

}  // namespace accord
