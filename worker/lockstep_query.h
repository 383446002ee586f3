// For large crowds of discs or balls, before the hierarchy's levels: all robots to their goals in
// lockstep on a lattice, then each path shortened among the others. Cares about everyone having a
// path first, and about good paths second, where the levels would take too long.
#pragma once

#include "worker/solver.h"

namespace accord {

class LockstepQuery final : public Solver {
 public:
  static constexpr std::string_view kName = "lockstep-query";
  std::string_view name() const override { return kName; }

 private:
  bool takes(const Subproblem& subproblem) const override { return subproblem.lockstep; }
  Resolution do_solve(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop) const override;
};

}  // namespace accord
