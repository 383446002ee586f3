// The baselines: each robot alone first, and if any two of these paths conflict, the whole problem
// as one subproblem of all robots, from start to goal, for one solver that goes on until it has
// solved it or is stopped. What ARC would do if it grew every subproblem as far as it goes at once.
#pragma once

#include <atomic>

#include "common/geometry/collision_world.h"
#include "coordinator/method.h"
#include "coordinator/progress.h"
#include "coordinator/subproblem_factory.h"
#include "coordinator/workforce.h"

namespace accord {

class WholeProblem final : public Method {
 public:
  // As Arc's. The workforce's hierarchy is the one solver.
  WholeProblem(const CollisionWorld& planning, const CollisionWorld& detection, std::uint64_t seed,
               Workforce& workforce, const std::atomic<bool>& stop, ProgressCallback progress);

  Outcome run() override;
  const Schedule& schedule() const override { return schedule_; }
  const PlanningStatistics& statistics() const override { return statistics_; }

 private:
  Outcome solve(const Conflict& first, const Outcome& when_stopped);

  const CollisionWorld& planning_;
  const CollisionWorld& detection_;
  Workforce& workforce_;
  const std::atomic<bool>& stop_;
  ProgressCallback progress_;
  SubproblemFactory factory_;
  Schedule schedule_;
  PlanningStatistics statistics_;
};

}  // namespace accord
