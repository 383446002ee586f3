// A way to plan a whole scene: ARC, or one of the baselines that it is compared with.
// Not thread safe; runs once.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "common/geometry/collision_world.h"
#include "common/planning/schedule.h"
#include "common/planning/subproblem.h"
#include "coordinator/conflict_board.h"
#include "coordinator/outcome.h"
#include "coordinator/progress.h"
#include "coordinator/subproblem_factory.h"
#include "coordinator/workforce.h"

namespace accord {

struct PlanningStatistics {
  std::uint64_t conflicts_found = 0;
  std::uint64_t conflicts_resolved = 0;
  std::uint64_t rounds = 0;
  std::uint64_t subproblems = 0;
  std::uint64_t exhausted = 0;
  std::uint64_t windows_grown = 0;
  std::uint64_t robots_taken_in = 0;
  std::uint64_t pair_checks = 0;
  std::map<std::string, std::uint64_t> solved_by;  // solver name -> resolutions committed
  Effort effort;                                   // of all attempts
  std::uint64_t distance_queries = 0;              // of the coordinator's own
  double initial_time = 0;                         // s, wall clock
  double conflict_time = 0;                        // s
  double lower_bound = 0;                          // s: sum of the robots' own paths' durations
};

// Each robot's own path first, as if it were alone (Alg. 1, lines 2 to 5); how the conflicts
// between these are resolved is what methods differ in.
class Method {
 public:
  // Two worlds of the same scene: conflicts are looked for with a smaller margin than planning
  // keeps, so that what planning avoids is not found to be a conflict again for rounding.
  Method(const CollisionWorld& planning, const CollisionWorld& detection, std::uint64_t seed,
         Workforce& workforce, const std::atomic<bool>& stop, ProgressCallback progress);
  virtual ~Method() = default;

  // Throws std::logic_error when the workforce breaks its contract.
  Outcome run();
  // The paths, once run() has solved it.
  const Schedule& schedule() const { return schedule_; }
  const PlanningStatistics& statistics() const { return statistics_; }

 protected:
  const Scene& scene() const { return planning_.scene(); }
  // `conflicts_left`: of those found, the ones that are still in the schedule.
  void report_conflicts(std::size_t conflicts_left) const;

  const CollisionWorld& planning_;
  Workforce& workforce_;
  const std::atomic<bool>& stop_;
  SubproblemFactory factory_;
  Schedule schedule_;
  PlanningStatistics statistics_;

 private:
  // Makes the schedule free of conflicts. The board has looked at nothing yet.
  virtual Outcome resolve(ConflictBoard& board) = 0;
  Outcome plan();
  std::optional<Outcome> plan_initial_paths();
  void report_initial_paths(std::size_t robots_planned) const;

  const CollisionWorld& detection_;
  ProgressCallback progress_;
};

}  // namespace accord
