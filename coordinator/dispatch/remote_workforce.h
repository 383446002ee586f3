// A workforce of whoever is on the bus: hands subproblems to worker processes and waits for what
// they return, through deaths and lost messages.
//
// Not thread safe: solve() runs the loop that owns the bus and the books.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/transport/bus.h"
#include "coordinator/dispatch/task_board.h"
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
  // One turn of the loop: moves time on, lets others work; returns what the time is then.
  // For a real bus: waits for an event.
  using Turn = std::function<TaskBoard::Time(Bus& bus, std::optional<TaskBoard::Time> deadline)>;

  // For one request, in the world's scene, by one hierarchy. All must outlive this.
  // Requires: the world's margin is kDetectionMargin.
  RemoteWorkforce(Bus& bus, TaskBoard& board, RequestId request, const CollisionWorld& world,
                  const std::vector<std::string>& solvers, Turn turn);
  ~RemoteWorkforce() override;

  // Throws TaskFailure.
  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>& stop) override;

 private:
  void run_loop_once();
  void take_results(const std::vector<Subproblem>& subproblems, TaskId first,
                    std::vector<Resolution>& out, std::size_t& left);
  void refuse(const FinishedTask& finished, std::size_t i, const std::string& fault);

  Bus& bus_;
  TaskBoard& board_;
  RequestId request_;
  const CollisionWorld& world_;
  Turn turn_;
  TaskBoard::Time now_{0};
  TaskId next_task_ = 1;
  std::vector<Bytes> sent_;     // payloads of the present tasks
  std::vector<Bytes> refused_;  // what was returned last of each and does not hold
};

}  // namespace accord
