#include "common/planning/verifier_form.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <unordered_map>

#include "common/planning/verifier_words.h"

namespace accord::verification {
namespace {

using RobotPlans = std::unordered_map<std::string_view, const RobotPlan*>;

Violation malformed(std::vector<std::string> robots, std::string text, double time = 0) {
  return {Violation::Kind::kForm, std::move(robots), time, Vec3::Zero(), 0, std::move(text)};
}

std::string waypoint(std::size_t index) {
  return "waypoint " + std::to_string(index);
}

std::optional<Violation> check_robots(const Scene& scene, const Plan& plan) {
  RobotPlans planned;
  for (const RobotPlan& robot : plan.robots) {
    if (!planned.emplace(robot.name, &robot).second) {
      return malformed({robot.name}, quoted(robot.name) + " is in the plan twice");
    }
  }
  RobotPlans unknown = planned;
  for (const Robot& robot : scene.robots) {
    if (unknown.erase(robot.name) == 0) {
      return malformed({robot.name}, quoted(robot.name) + " is missing from the plan");
    }
  }
  for (const RobotPlan& robot : plan.robots) {
    if (unknown.contains(robot.name)) {
      return malformed({robot.name}, "the scene has no robot " + quoted(robot.name));
    }
  }
  return std::nullopt;
}

std::optional<Violation> check_times(const std::string& name, const Trajectory& path) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!std::isfinite(path.time(i))) {
      return malformed({name}, quoted(name) + ", " + waypoint(i) + ": its time is not finite");
    }
    if (i > 0 && path.time(i) <= path.time(i - 1)) {
      return malformed({name},
                       quoted(name) + ", " + waypoint(i) + " at " + seconds(path.time(i)) +
                           " does not come after the one before it at " + seconds(path.time(i - 1)),
                       path.time(i));
    }
  }
  if (path.start_time() != 0) {
    return malformed({name}, quoted(name) + " has its first waypoint at " +
                                 seconds(path.start_time()) + " and not at t = 0");
  }
  return std::nullopt;
}

std::optional<Violation> check_path(const Robot& robot, const Trajectory& path) {
  const std::string& name = robot.name;
  if (path.empty()) return malformed({name}, quoted(name) + " has no waypoints");
  if (path.dof() != robot.model->dof()) {
    return malformed({name}, quoted(name) + " has configurations of " + std::to_string(path.dof()) +
                                 " numbers; its model " + quoted(robot.model->name) + " has " +
                                 std::to_string(robot.model->dof()));
  }
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!std::ranges::all_of(path.configuration(i), [](double x) { return std::isfinite(x); })) {
      return malformed({name},
                       quoted(name) + ", " + waypoint(i) + ": its configuration is not finite");
    }
  }
  return check_times(name, path);
}

// Room for the rounding of whoever summed the costs.
bool differs(double claimed, double actual) {
  return !(std::abs(claimed - actual) <= 1e-6 * std::max(1.0, std::abs(actual)));
}

Violation wrong_cost(const std::string& what, double claimed, double actual, double time) {
  return {
      Violation::Kind::kCosts,
      {},
      time,
      Vec3::Zero(),
      claimed - actual,
      "the plan says that its " + what + " is " + number(claimed) + "; it is " + number(actual)};
}

}  // namespace

std::optional<Violation> check_form(const Scene& scene, const Plan& plan) {
  if (plan.status != PlanStatus::kSolved) {
    return malformed({}, "the plan's status is " + std::string(to_string(plan.status)) +
                             ", so there is nothing to prove");
  }
  if (auto violation = check_robots(scene, plan)) return violation;
  const std::vector<const Trajectory*> paths = paths_in_order(scene, plan);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (auto violation = check_path(scene.robots[i], *paths[i])) return violation;
  }
  return std::nullopt;
}

std::vector<const Trajectory*> paths_in_order(const Scene& scene, const Plan& plan) {
  std::unordered_map<std::string_view, const Trajectory*> by_name;
  for (const RobotPlan& robot : plan.robots) by_name.emplace(robot.name, &robot.trajectory);
  std::vector<const Trajectory*> paths;
  for (const Robot& robot : scene.robots) paths.push_back(by_name.at(robot.name));
  return paths;
}

std::optional<Violation> check_costs(const Scene& scene, const Plan& plan) {
  constexpr double kRounding = 1e-9;  // of an arrival in timesteps; either way is right within it
  double makespan = 0;
  double sum = 0;
  double least_timesteps = 0;
  double most_timesteps = 0;
  for (const RobotPlan& robot : plan.robots) {
    const double arrival = robot.trajectory.arrival_time();
    makespan = std::max(makespan, arrival);
    sum += arrival;
    least_timesteps += std::ceil(arrival / scene.timestep - kRounding);
    most_timesteps += std::ceil(arrival / scene.timestep + kRounding);
  }
  if (differs(plan.timestep, scene.timestep)) {
    return wrong_cost("timestep", plan.timestep, scene.timestep, makespan);
  }
  if (differs(plan.makespan, makespan)) {
    return wrong_cost("makespan", plan.makespan, makespan, makespan);
  }
  if (differs(plan.sum_of_costs, sum)) {
    return wrong_cost("sum of costs", plan.sum_of_costs, sum, makespan);
  }
  const auto timesteps = static_cast<double>(plan.sum_of_costs_timesteps);
  if (timesteps < least_timesteps || timesteps > most_timesteps) {
    return wrong_cost("sum of costs in timesteps", timesteps, least_timesteps, makespan);
  }
  return std::nullopt;
}

}  // namespace accord::verification
