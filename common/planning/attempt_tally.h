// How attempts at subproblems went, level by level, for whoever watches over a service.
// Thread safe.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "common/planning/levels.h"
#include "common/planning/method_names.h"

namespace accord {

class AttemptTally {
 public:
  using Outcomes = std::array<std::uint64_t, kLevelOutcomes>;  // by LevelOutcome
  using Totals = std::map<std::string, Outcomes>;              // by solver, as counted_solver()

  void count(const std::vector<TriedLevel>& levels) {
    const std::lock_guard lock(mutex_);
    for (const auto& [solver, outcome] : levels) {
      ++totals_[counted_solver(solver)].at(static_cast<std::size_t>(outcome));
    }
  }
  Totals totals() const {
    const std::lock_guard lock(mutex_);
    return totals_;
  }

 private:
  mutable std::mutex mutex_;
  Totals totals_;
};

}  // namespace accord
