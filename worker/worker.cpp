#include "worker/worker.h"

#include "worker/path_planner.h"

namespace accord {

Resolution Worker::solve(const Subproblem& subproblem, const std::atomic<bool>& stop) const {
  if (subproblem.tasks.size() == 1 && subproblem.outsiders.empty()) {
    return plan_alone(workspace_, subproblem, stop);
  }
  return hierarchy_.solve(workspace_, subproblem, stop);
}

}  // namespace accord
