// Level 1 of the hierarchy: no sampling. The robots' present paths are their roadmaps; each robot
// in turn takes the earliest way through among the robots before it, waiting where that helps.
#pragma once

#include "worker/solver.h"

namespace accord {

class PrioritizedQuery final : public Solver {
 public:
  static constexpr std::string_view kName = "prioritized-query";
  std::string_view name() const override { return kName; }

 private:
  Resolution do_solve(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop) const override;
};

}  // namespace accord
