// A crew of worker processes: puts attempts on the task board and takes what comes back, through
// deaths and lost messages.
// Not thread safe.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "common/geometry/collision_world.h"
#include "coordinator/crew.h"
#include "coordinator/dispatch/task_port.h"

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

class RemoteCrew final : public Crew {
 public:
  // For one request, in the world's scene. The world must outlive this.
  // Requires: its margin is kDetectionMargin.
  RemoteCrew(std::unique_ptr<TaskPort> port, const CollisionWorld& world);

  void begin(std::vector<Attempt> attempts) override;
  void hurry(const std::vector<Ticket>& tickets) override;
  void drop(const std::vector<Ticket>& tickets) override;
  // What nobody could carry out comes back with a TaskFailure.
  std::vector<Attempted> wait(const std::atomic<bool>& stop) override;
  // One where there are no workers yet: so many are waited for.
  std::size_t hands() const override;

 private:
  struct UnderWay {
    Ticket ticket;
    std::shared_ptr<const Subproblem> subproblem;
    Bytes refused;  // what came back of it last and does not hold
  };

  // nullopt: what came back does not hold, and is asked for again.
  std::optional<Attempted> answer(const FinishedTask& finished, UnderWay& task);
  std::optional<std::string> fault_of(
      const Subproblem& subproblem, const tl::expected<Resolution, std::string>& resolution) const;

  std::unique_ptr<TaskPort> port_;
  const CollisionWorld& world_;
  std::map<TaskId, UnderWay> under_way_;
  std::map<Ticket, TaskId> tasks_;  // the same
};

}  // namespace accord
