#include "worker/worker.h"

namespace accord {

Resolution Worker::solve(const Subproblem& subproblem, const std::atomic<bool>& stop) const {
  if (subproblem.tasks.size() == 1 && subproblem.outsiders.empty()) {
    return path_planner_.plan(subproblem, stop);
  }
  return hierarchy_.solve(world_, subproblem, stop);
}

}  // namespace accord
