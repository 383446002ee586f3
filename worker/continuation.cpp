#include "worker/continuation.h"

#include "common/planning/splice.h"

namespace accord {

Trajectory with_tail(const CollisionWorld& world, const Task& task, const Trajectory& local) {
  Trajectory path = local;
  if (task.goes_on()) {
    append_tail(*world.scene().robot(task.robot).model, task.tail, task.to, path);
  }
  return path;
}

double hold_until(const Subproblem& subproblem, const Task& task) {
  return task.goes_on() ? subproblem.from : subproblem.horizon;
}

}  // namespace accord
