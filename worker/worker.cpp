#include "worker/worker.h"

#include "common/geometry/query_counter.h"
#include "common/planning/levels.h"
#include "worker/path_planner.h"
#include "worker/solver.h"

namespace accord {

Resolution Worker::solve(const Subproblem& subproblem, const std::vector<std::string>& solvers,
                         const std::atomic<bool>& stop) const {
  const SeparateCost cost;
  Resolution resolution = is_robot_alone(subproblem)
                              ? plan_alone(workspace_, subproblem, stop)
                              : SolverHierarchy(solvers).solve(workspace_, subproblem, stop);
  resolution.effort.distance_queries = cost.so_far();
  return resolution;
}

}  // namespace accord
