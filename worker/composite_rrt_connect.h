// A further level of the hierarchy: two trees in the joint space of all the subproblem's robots,
// one from their starts and one from their goals, each grown towards the other (RRT-Connect;
// Kuffner and LaValle, ICRA 2000). The trees avoid obstacles and the robots each other; the way
// that joins them is then timed among the outsiders. Not probabilistically complete among
// outsiders; several ways are tried.
#pragma once

#include "worker/solver.h"

namespace accord {

class CompositeRrtConnect final : public Solver {
 public:
  static constexpr std::string_view kName = "composite-rrt-connect";
  std::string_view name() const override { return kName; }

 private:
  Resolution do_solve(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop) const override;
};

}  // namespace accord
