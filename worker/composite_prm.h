// Level 3 of the hierarchy: a roadmap in the joint space of all the subproblem's robots, searched
// in time against the outsiders. Sampling ends when it is no longer productive, by the evolution of
// the roadmap's components (Morales, Pearce and Amato, "Metrics for analyzing the evolution of
// C-space models", ICRA 2006), or at a count.
#pragma once

#include "worker/solver.h"

namespace accord {

class CompositePrm final : public Solver {
 public:
  static constexpr std::string_view kName = "composite-prm";
  std::string_view name() const override { return kName; }

 private:
  Resolution do_solve(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop) const override;
};

}  // namespace accord
