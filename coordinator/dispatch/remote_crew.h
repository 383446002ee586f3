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
#include "common/io/wire/task_record.h"
#include "common/planning/attempt_tally.h"
#include "coordinator/crew.h"
#include "coordinator/dispatch/task_port.h"

namespace accord {

// A task could not be solved by anybody: it kills its workers, none takes it, or two of them return
// the same resolution, which does not hold: then their solvers are wrong, not they. The request
// cannot be finished; its record says why, and lets `accord replay` try again.
class TaskFailure : public std::runtime_error {
 public:
  explicit TaskFailure(TaskRecord record)
      : std::runtime_error(record.why),
        record_(std::make_shared<const TaskRecord>(std::move(record))) {}
  const TaskRecord& record() const { return *record_; }

 private:
  std::shared_ptr<const TaskRecord> record_;  // copying an exception must not throw
};

class RemoteCrew final : public Crew {
 public:
  // For one request, in the world's scene. The world and the tally, where attempts are counted if
  // it is not null, must outlive this. Requires: the world's margin is kDetectionMargin.
  RemoteCrew(std::unique_ptr<TaskPort> port, const CollisionWorld& world,
             AttemptTally* tally = nullptr);

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
    std::vector<std::string> solvers;
    Bytes hierarchy;
    Bytes refused;  // what came back of it last and does not hold
  };

  // nullopt: what came back does not hold, and is asked for again.
  std::optional<Attempted> answer(const FinishedTask& finished, UnderWay& task);
  std::optional<std::string> fault_of(
      const Subproblem& subproblem, const tl::expected<Resolution, std::string>& resolution) const;

  std::vector<RoadmapPlace> places_of(const Subproblem& subproblem) const;

  std::unique_ptr<TaskPort> port_;
  const CollisionWorld& world_;
  AttemptTally* tally_;
  std::shared_ptr<const Bytes> scene_;  // as it is sent
  std::vector<RoadmapPlace> places_;    // by robot
  std::map<TaskId, UnderWay> under_way_;
  std::map<Ticket, TaskId> tasks_;  // the same
};

}  // namespace accord
