// For crowds of discs or balls that are too large for the hierarchy's levels, before all of them:
// the whole crowd to its goals in lockstep, on a lattice laid over its space. Finds everyone a way
// in a time that grows little faster than the crowd, at the price of ways that are longer.
//
// Whoever has not arrived when the crowd gets no closer to its goals goes on to its goal as if
// alone, and nobody looks out for robots outside the crowd: these conflicts, few among robots that
// have mostly parked, are left to later subproblems, for the levels to resolve.
#pragma once

#include "worker/solver.h"

namespace accord {

class LockstepQuery final : public Solver {
 public:
  static constexpr std::string_view kName = "lockstep-query";
  std::string_view name() const override { return kName; }

 private:
  Resolution do_solve(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop) const override;
};

}  // namespace accord
