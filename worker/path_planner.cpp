#include "worker/path_planner.h"

#include <algorithm>

#include "worker/roadmap_query.h"

namespace accord {
namespace {

// Times a path at the robot's limits from `from` (s) on.
Trajectory timed(const RobotModel& model, const std::vector<Configuration>& path, double from) {
  Trajectory out(model.dof());
  Configuration delta(model.dof());
  double t = from;
  out.append(from, path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    for (std::size_t k = 0; k < delta.size(); ++k) delta[k] = path[i][k] - path[i - 1][k];
    const double duration = least_duration(model, delta);
    if (duration <= 0) continue;
    t += duration;
    out.append(t, path[i]);
  }
  return out;
}

}  // namespace

Resolution plan_alone(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop) {
  const CollisionWorld& world = workspace.world();
  const Task& task = subproblem.tasks.front();
  const RobotModel& model = *world.scene().robot(task.robot).model;
  Resolution resolution;
  Configuration goal(task.goal.size());
  nearest_representation(model, task.start, task.goal, goal);
  std::vector<Configuration> path{task.start, goal};
  resolution.solver = kStraight;
  ++resolution.effort.motion_checks;
  resolution.solved = world.motion_is_free(task.robot, task.start, goal);
  for (std::size_t level = 0; !resolution.solved && level < RobotRoadmap::kLevels && !stop;
       ++level) {
    resolution.solver = kRoadmap;
    resolution.roadmap_level = static_cast<int>(level);
    auto found = shortest_path(workspace.roadmap(task.robot).level(level), task.start, task.goal,
                               resolution.effort);
    if (!found) continue;
    path = std::move(*found);
    shorten_alone(world, task.robot, subproblem.seed, path, resolution.effort);
    resolution.solved = true;
  }
  if (resolution.solved) {
    resolution.paths.push_back(timed(model, path, subproblem.from));
    resolution.end = resolution.paths.back().end_time();
  }
  return resolution;
}

}  // namespace accord
