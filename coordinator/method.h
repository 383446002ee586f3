// A way to plan a whole scene: ARC, or one of the baselines that it is compared with.
// Not thread safe; runs once.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "common/planning/schedule.h"
#include "common/planning/subproblem.h"
#include "coordinator/outcome.h"

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
  Effort effort;
  double initial_time = 0;   // s, wall clock
  double conflict_time = 0;  // s
  double lower_bound = 0;    // s: sum of the robots' own paths' durations
};

class Method {
 public:
  virtual ~Method() = default;

  // Throws std::logic_error when the workforce breaks its contract.
  virtual Outcome run() = 0;
  // The paths, once run() has solved it.
  virtual const Schedule& schedule() const = 0;
  virtual const PlanningStatistics& statistics() const = 0;
};

}  // namespace accord
