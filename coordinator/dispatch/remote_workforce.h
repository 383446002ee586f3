// A workforce of whoever is on the bus: hands subproblems to worker processes and waits for what
// they return, through deaths and lost messages.
//
// Not thread safe: solve() runs the loop that owns the bus and the books.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/model/scene.h"
#include "common/transport/bus.h"
#include "coordinator/dispatch/task_board.h"
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
  // One turn of the loop: moves time on, lets others work; returns what the time is then.
  // For a real bus: waits for an event.
  using Turn = std::function<TaskBoard::Time(Bus& bus, std::optional<TaskBoard::Time> deadline)>;

  // For one request, in one scene, by one hierarchy. All must outlive this.
  RemoteWorkforce(Bus& bus, TaskBoard& board, RequestId request, std::shared_ptr<const Scene> scene,
                  const std::vector<std::string>& solvers, Turn turn);
  ~RemoteWorkforce() override;

  // Throws TaskFailure.
  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>& stop) override;

 private:
  void run_loop_once();
  void take_results(const std::vector<Subproblem>& subproblems, TaskId first,
                    std::vector<Resolution>& out, std::size_t& left);

  Bus& bus_;
  TaskBoard& board_;
  RequestId request_;
  std::shared_ptr<const Scene> scene_;
  Turn turn_;
  TaskBoard::Time now_{0};
  TaskId next_task_ = 1;
  std::vector<Bytes> sent_;  // payloads of the present tasks
};

}  // namespace accord
