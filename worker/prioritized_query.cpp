#include "worker/prioritized_query.h"

#include "worker/decoupled_roadmaps.h"
#include "worker/prioritized_search.h"

namespace accord {

Resolution PrioritizedQuery::do_solve(const CollisionWorld& world, const Subproblem& subproblem,
                                      const std::atomic<bool>& stop) const {
  DecoupledRoadmaps roadmaps(world, subproblem);
  Resolution resolution = prioritized_search(world, subproblem, roadmaps, stop);
  resolution.solver = kName;
  return resolution;
}

}  // namespace accord
