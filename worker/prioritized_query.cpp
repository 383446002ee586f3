#include "worker/prioritized_query.h"

#include "worker/decoupled_roadmaps.h"
#include "worker/prioritized_search.h"

namespace accord {

Resolution PrioritizedQuery::do_solve(const Workspace& workspace, const Subproblem& subproblem,
                                      const std::atomic<bool>& stop) const {
  DecoupledRoadmaps roadmaps(workspace, subproblem);
  Resolution resolution = prioritized_search(workspace.world(), subproblem, roadmaps, stop);
  resolution.solver = kName;
  return resolution;
}

}  // namespace accord
