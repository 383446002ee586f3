// CBS-MP: conflict-based search on the robots' own roadmaps, best first over the sum of arrivals
// (Solis, Motes, Sandstrom and Amato, "Representation-optimal multi-robot motion planning using
// conflict-based search", RA-L 2021). A conflict is resolved in two ways, each of which forbids one
// of the two robots what it was doing during the time in which it would run into the other;
// intervals come from continuous time (as in Andreychuk et al., "Multi-agent pathfinding with
// continuous time", IJCAI 2019). The low level is safe-interval search. Where the roadmaps hold no
// solution they grow.
//
// A baseline for whole problems: it goes on until it has solved one or is stopped.
#pragma once

#include "worker/solver.h"

namespace accord {

class CbsMp final : public Solver {
 public:
  static constexpr std::string_view kName = "cbs-mp";
  std::string_view name() const override { return kName; }

 private:
  Resolution do_solve(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop) const override;
};

}  // namespace accord
