#include "worker/uncoupling.h"

#include <algorithm>

#include "common/planning/conflict.h"
#include "worker/continuation.h"
#include "worker/path_shortening.h"
#include "worker/team.h"

namespace accord {

namespace {

// Whether robot i, going on along its tail after `path`, stays clear of the rest of the team.
bool is_clear_of_team(const CollisionWorld& world, const Subproblem& subproblem,
                      const Resolution& resolution, std::size_t i, const Trajectory& path) {
  const Task& mine = subproblem.tasks[i];
  const Trajectory onwards = with_tail(world, mine, path);
  for (std::size_t j = 0; j < resolution.paths.size(); ++j) {
    if (j == i) continue;
    const Task& other = subproblem.tasks[j];
    const Trajectory theirs = with_tail(world, other, resolution.paths[j]);
    const double until = std::max(subproblem.horizon, resolution.end);
    if (earliest_contact(world, mine.robot, onwards, other.robot, theirs, subproblem.from, until)) {
      return false;
    }
  }
  return true;
}

}  // namespace

void uncouple(const CollisionWorld& world, const Subproblem& subproblem, Resolution& resolution,
              const std::atomic<bool>& stop) {
  for (std::size_t i = 0; i < resolution.paths.size(); ++i) {
    const Task& task = subproblem.tasks[i];
    Team team(world, {task.robot}, subproblem.from);
    team.avoid_outsiders(subproblem);
    for (std::size_t j = 0; j < resolution.paths.size(); ++j) {
      if (j == i) continue;
      team.avoid(subproblem.tasks[j].robot,
                 with_tail(world, subproblem.tasks[j], resolution.paths[j]));
    }
    const SearchRequest request{0,
                                1,
                                subproblem.from,
                                hold_until(subproblem, task),
                                subproblem.limits.query_expansions,
                                subproblem.limits.query_checks};
    Trajectory path = resolution.paths[i].tidied();
    shorten(team, request, path, stop, resolution.effort);
    if (is_clear_of_team(world, subproblem, resolution, i, path)) {
      resolution.paths[i] = std::move(path);
    }
  }
  resolution.end = subproblem.from;
  for (const Trajectory& path : resolution.paths) {
    resolution.end = std::max(resolution.end, path.end_time());
  }
}

}  // namespace accord
