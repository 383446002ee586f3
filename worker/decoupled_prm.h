// Level 2 of the hierarchy: samples are added to each robot's own roadmap inside its region, a
// batch at a time, and the prioritized query is put again. Fails fast, by count.
// (Decoupled PRM; Sanchez and Latombe 2002)
#pragma once

#include "worker/solver.h"

namespace accord {

class DecoupledPrm final : public Solver {
 public:
  static constexpr std::string_view kName = "decoupled-prm";
  std::string_view name() const override { return kName; }

 private:
  Resolution do_solve(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop) const override;
};

}  // namespace accord
