// A workforce of worker processes: puts subproblems on the task board and takes what comes back,
// through deaths and lost messages.
// Not thread safe.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/geometry/collision_world.h"
#include "coordinator/dispatch/task_port.h"
#include "coordinator/workforce.h"

namespace accord {

// A task could not be solved by anybody: it kills its workers, none takes it, or two of them return
// the same resolution, which does not hold: then their solvers are wrong, not they. The request
// cannot be finished; whoever has the subproblem can look at it.
class TaskFailure : public std::runtime_error {
 public:
  TaskFailure(const std::string& why, Bytes subproblem)
      : std::runtime_error(why), subproblem_(std::move(subproblem)) {}
  const Bytes& subproblem() const { return subproblem_; }

 private:
  Bytes subproblem_;
};

class RemoteWorkforce final : public Workforce {
 public:
  // For one request, in the world's scene, by one hierarchy. The world must outlive this.
  // Requires: its margin is kDetectionMargin.
  RemoteWorkforce(std::unique_ptr<TaskPort> port, const CollisionWorld& world,
                  const std::vector<std::string>& solvers);

  // Throws TaskFailure.
  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>& stop) override;

 private:
  struct Sent {
    std::size_t place;  // of its subproblem
    Bytes refused;      // what was returned of it last and does not hold
  };
  std::optional<Resolution> take(const FinishedTask& finished, const Subproblem& subproblem,
                                 Sent& sent);

  std::unique_ptr<TaskPort> port_;
  const CollisionWorld& world_;
};

}  // namespace accord
