#include "worker/path_planner.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace accord {
namespace {

// Robots with equal keys share a roadmap: same model, same place.
using Place = std::tuple<const RobotModel*, std::vector<double>>;

Place place_of(const Robot& robot) {
  const auto& m = robot.base.matrix();
  return {robot.model.get(), std::vector<double>(m.data(), m.data() + m.size())};
}

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

PathPlanner::PathPlanner(const CollisionWorld& world) : world_(world) {
  std::map<Place, std::shared_ptr<RobotRoadmap>> known;
  const auto count = static_cast<std::uint32_t>(world.scene().robots.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    auto& roadmap = known[place_of(world.scene().robot({i}))];
    if (!roadmap) roadmap = std::make_shared<RobotRoadmap>(world, RobotId{i});
    roadmaps_.push_back(roadmap);
  }
}

Resolution PathPlanner::plan(const Subproblem& subproblem, const std::atomic<bool>& stop) const {
  const Task& task = subproblem.tasks.front();
  const RobotModel& model = *world_.scene().robot(task.robot).model;
  Resolution resolution;
  Configuration goal(task.goal.size());
  nearest_representation(model, task.start, task.goal, goal);
  std::vector<Configuration> path{task.start, goal};
  resolution.solver = kStraight;
  ++resolution.effort.motion_checks;
  resolution.solved = world_.motion_is_free(task.robot, task.start, goal);
  const RobotRoadmap& roadmap = *roadmaps_[task.robot.index()];
  for (std::size_t level = 0; !resolution.solved && level < RobotRoadmap::kLevels && !stop;
       ++level) {
    resolution.solver = kRoadmap;
    auto found = roadmap.query(level, task.start, task.goal, resolution.effort);
    if (!found) continue;
    path = std::move(*found);
    shorten_alone(world_, task.robot, subproblem.seed, path, resolution.effort);
    resolution.solved = true;
  }
  if (resolution.solved) {
    resolution.paths.push_back(timed(model, path, subproblem.from));
    resolution.end = resolution.paths.back().end_time();
  }
  return resolution;
}

}  // namespace accord
