#include "tests/unit/worker/solver_contract.h"

#include <algorithm>
#include <cmath>

#include "common/planning/conflict.h"

namespace accord::testing {
namespace {

std::string form_breach(const Scene& scene, const Subproblem& subproblem,
                        const Resolution& resolution, std::size_t i) {
  const Task& task = subproblem.tasks[i];
  const Trajectory& path = resolution.paths[i];
  if (path.empty() || path.dof() != task.start.size()) return "a path is missing";
  if (path.start_time() != subproblem.from) return "a path does not begin with the window";
  if (path.end_time() > resolution.end) return "a path ends after all are said to have arrived";
  if (!std::ranges::equal(path.configuration(0), task.start)) return "a path leaves its start";
  Configuration delta(task.goal.size());
  const RobotModel& model = *scene.robot(task.robot).model;
  difference(model, task.goal, path.configuration(path.size() - 1), delta);
  for (const double d : delta) {
    if (std::abs(d) > 1e-9) return "a path misses its goal";
  }
  for (std::size_t k = 1; k < path.size(); ++k) {
    for (std::size_t d = 0; d < delta.size(); ++d) {
      delta[d] = path.configuration(k)[d] - path.configuration(k - 1)[d];
    }
    if (least_duration(model, delta) > (path.time(k) - path.time(k - 1)) * (1 + 1e-6)) {
      return "a path is faster than its robot";
    }
  }
  return {};
}

}  // namespace

std::string contract_breach(const CollisionWorld& world, const Subproblem& subproblem,
                            const Resolution& resolution) {
  if (!resolution.solved) return {};
  const auto& tasks = subproblem.tasks;
  if (resolution.paths.size() != tasks.size()) return "not one path a robot";
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const auto breach = form_breach(world.scene(), subproblem, resolution, i);
    if (!breach.empty()) return breach;
    const Trajectory& path = resolution.paths[i];
    for (std::size_t k = 1; k < path.size(); ++k) {
      if (!world.motion_is_free(tasks[i].robot, path.configuration(k - 1), path.configuration(k))) {
        return "a path runs into an obstacle";
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (earliest_contact(world, tasks[i].robot, path, tasks[j].robot, resolution.paths[j],
                           subproblem.from, std::min(resolution.end, subproblem.clear_until))) {
        return "two robots of the team meet";
      }
    }
    for (const Outsider& outsider : subproblem.outsiders) {
      if (earliest_contact(world, tasks[i].robot, path, outsider.robot, outsider.path,
                           subproblem.from, std::min(resolution.end, outsider.until))) {
        return "a robot runs into an outsider";
      }
    }
  }
  return {};
}

}  // namespace accord::testing
