#include "worker/uncoupling.h"

#include <algorithm>

#include "worker/path_shortening.h"
#include "worker/team.h"

namespace accord {

void uncouple(const CollisionWorld& world, const Subproblem& subproblem, Resolution& resolution) {
  for (std::size_t i = 0; i < resolution.paths.size(); ++i) {
    Team team(world, {subproblem.tasks[i].robot}, subproblem.from, subproblem.latest);
    for (const Outsider& outsider : subproblem.outsiders) {
      team.avoid(outsider.robot, outsider.path);
    }
    for (std::size_t j = 0; j < resolution.paths.size(); ++j) {
      if (j != i) team.avoid(subproblem.tasks[j].robot, resolution.paths[j]);
    }
    const SearchRequest request{0, 1, subproblem.from, resolution.end, subproblem.latest,
                                subproblem.limits.query_expansions};
    SearchResult result{resolution.paths[i].tidied(), resolution.end};
    shorten(team, request, result, resolution.effort);
    resolution.paths[i] = std::move(result.path);
  }
  resolution.end = subproblem.from;
  for (const Trajectory& path : resolution.paths) {
    resolution.end = std::max(resolution.end, path.end_time());
  }
}

}  // namespace accord
