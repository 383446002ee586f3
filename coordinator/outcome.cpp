#include "coordinator/outcome.h"

#include <fmt/format.h>

namespace accord {
namespace {

std::string quoted(const Scene& scene, RobotId robot) {
  return fmt::format("\"{}\"", scene.robot(robot).name);
}

// The conflict that ARC was about to look at.
std::string earliest(const Scene& scene, const ConflictBoard& board) {
  const Conflict& conflict = *board.conflicts().begin();
  return fmt::format("the earliest of robots {} and {} at {:.3f} s", quoted(scene, conflict.first),
                     quoted(scene, conflict.second), conflict.time);
}

}  // namespace

Outcome no_way_alone(const Scene& scene, RobotId robot) {
  return {PlanStatus::kInfeasible,
          fmt::format("no way from start to goal was found for robot {} on its own, on the largest "
                      "roadmap of its configuration space",
                      quoted(scene, robot))};
}

Outcome unresolved(const Scene& scene, const Conflict& conflict, const Subproblem& subproblem) {
  std::string robots;
  for (const Task& task : subproblem.tasks) {
    robots += (robots.empty() ? "" : ", ") + quoted(scene, task.robot);
  }
  return {PlanStatus::kInfeasible,
          fmt::format("the conflict of robots {} and {} at {:.3f} s could not be resolved, even "
                      "with {} planned together from start to goal",
                      quoted(scene, conflict.first), quoted(scene, conflict.second), conflict.time,
                      robots)};
}

Outcome given_up(const Scene& scene, const ConflictBoard& board, std::uint64_t resolutions) {
  return {PlanStatus::kTimeout,
          fmt::format("after {} resolutions, the most for so many robots, conflicts keep coming "
                      "back: {} are left, {}",
                      resolutions, board.size(), earliest(scene, board))};
}

Outcome stopped_alone(const Scene& scene, RobotId next) {
  return {PlanStatus::kCancelled,
          fmt::format("while each robot was planned alone, from robot {} on", quoted(scene, next))};
}

Outcome stopped(const Scene& scene, const ConflictBoard& board) {
  return {PlanStatus::kCancelled,
          fmt::format("with {} conflicts left, {}", board.size(), earliest(scene, board))};
}

}  // namespace accord
