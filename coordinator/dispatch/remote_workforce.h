// A workforce of worker processes: puts subproblems on the task board and takes what comes back,
// through deaths and lost messages.
// Not thread safe.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/model/scene.h"
#include "coordinator/dispatch/task_port.h"
#include "coordinator/workforce.h"

namespace accord {

// A task could not be solved by anybody: it kills its workers, or none takes it. The request cannot
// be finished; whoever has the subproblem can look at it.
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
  // For one request, in one scene, by one hierarchy.
  RemoteWorkforce(std::unique_ptr<TaskPort> port, std::shared_ptr<const Scene> scene,
                  const std::vector<std::string>& solvers);

  // Throws TaskFailure.
  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>& stop) override;

 private:
  std::unique_ptr<TaskPort> port_;
  std::shared_ptr<const Scene> scene_;
};

}  // namespace accord
