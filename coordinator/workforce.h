// Whoever solves subproblems for a method of planning: the Foreman, or a test's script.
#pragma once

#include <atomic>
#include <vector>

#include "common/planning/subproblem.h"

namespace accord {

class Workforce {
 public:
  virtual ~Workforce() = default;

  // The resolution of each subproblem, in the same order. May solve them in any order or at the
  // same time; what comes back depends on the subproblems alone, unless `stop` becomes true, which
  // leaves some unsolved.
  virtual std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                        const std::atomic<bool>& stop) = 0;
};

}  // namespace accord
