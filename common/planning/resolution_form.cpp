#include "common/planning/resolution_form.h"

#include <algorithm>
#include <cmath>

#include "common/planning/verifier_words.h"

namespace accord {
namespace {

using verification::quoted;
using verification::seconds;

// Whether a path's end is the task's goal, up to whole turns.
bool reaches_goal(const RobotModel& model, const Task& task, ConfigurationView end) {
  constexpr double kSamePlace = 1e-9;
  Configuration delta(end.size());
  difference(model, task.goal, end, delta);
  return std::ranges::all_of(delta, [](double d) { return std::abs(d) <= kSamePlace; });
}

bool has_sound_times(const Trajectory& path) {
  const auto is_not_later = [](double t, double next) { return !(next > t); };
  return std::isfinite(path.end_time()) &&
         std::ranges::adjacent_find(path.times(), is_not_later) == path.times().end();
}

// What is wrong with a path, to follow its robot's name.
std::optional<std::string> path_fault(const Scene& scene, double from, const Task& task,
                                      const Trajectory& path) {
  if (path.empty() || path.dof() != task.start.size()) return "has no path of its own size";
  if (!has_sound_times(path)) return "has a path whose times do not increase";
  if (path.start_time() != from) {
    return "sets out at " + seconds(path.start_time()) + ", not with the window at " +
           seconds(from);
  }
  if (!std::ranges::equal(path.configuration(0), task.start)) return "does not begin at its start";
  const RobotModel& model = *scene.robot(task.robot).model;
  if (!reaches_goal(model, task, path.configuration(path.size() - 1))) {
    return "does not end at its goal";
  }
  return std::nullopt;
}

std::optional<std::string> left_fault(const Scene& scene, const Subproblem& subproblem,
                                      const Resolution& resolution) {
  if (resolution.left.empty()) return std::nullopt;
  if (resolution.solved ? !subproblem.lockstep : !subproblem.is_crowd()) {
    return "robots are left of a team that may leave nobody";
  }
  for (const RobotId robot : resolution.left) {
    const auto task = std::ranges::find(subproblem.tasks, robot, &Task::robot);
    if (task == subproblem.tasks.end()) return "a robot is left that is not of the team";
    const auto i = static_cast<std::size_t>(task - subproblem.tasks.begin());
    if (!resolution.solved && resolution.paths[i] != task->guide) {
      return quoted(scene.robot(robot).name) + " is left, but not on its present path";
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> form_fault(const Scene& scene, const Subproblem& subproblem,
                                      const Resolution& resolution) {
  if (!resolution.solved && !resolution.improves()) return "it is not solved";
  if (resolution.paths.size() != subproblem.tasks.size()) return "it does not hold a path a robot";
  double end = subproblem.from;
  for (std::size_t i = 0; i < resolution.paths.size(); ++i) {
    const Task& task = subproblem.tasks[i];
    const Trajectory& path = resolution.paths[i];
    if (auto fault = path_fault(scene, subproblem.from, task, path)) {
      return quoted(scene.robot(task.robot).name) + " " + *fault;
    }
    end = std::max(end, path.end_time());
  }
  if (resolution.end != end) {
    return "the last robot arrives at " + seconds(end) + ", not at " + seconds(resolution.end);
  }
  return left_fault(scene, subproblem, resolution);
}

}  // namespace accord
