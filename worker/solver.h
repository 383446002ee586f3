// One way to solve a subproblem. Implementations: LockstepQuery, PrioritizedQuery, DecoupledPrm,
// CompositeRrtConnect, CompositePrm, and SolverHierarchy, which tries a list of them in order.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/planning/subproblem.h"
#include "worker/workspace.h"

namespace accord {

class Solver {
 public:
  virtual ~Solver() = default;

  // A resolution whose local paths are free, at every instant, of obstacles, and of each other and
  // the outsiders until they leave the window, each robot on its own (resolution_check.h says when,
  // and what crowds promise instead); or one that is not solved.
  // Depends on the subproblem alone, unless `stop` becomes true, which ends the attempt unsolved
  // soon. Requires: the subproblem is of the workspace's scene. Thread safe.
  Resolution solve(const Workspace& workspace, const Subproblem& subproblem,
                   const std::atomic<bool>& stop) const;

  virtual std::string_view name() const = 0;

 private:
  // As levels.h says of solvers by their names.
  virtual bool takes(const Subproblem& subproblem) const;
  virtual Resolution do_solve(const Workspace& workspace, const Subproblem& subproblem,
                              const std::atomic<bool>& stop) const = 0;
};

// Those of local_solver_names(), and "cbs-mp", which solves whole problems only.
// nullptr for an unknown name.
std::unique_ptr<Solver> make_solver(std::string_view name);

// The solvers of the list one after another, until one solves it. (Alg. 2, lines 3 to 8)
class SolverHierarchy final : public Solver {
 public:
  // Requires: names are known.
  explicit SolverHierarchy(const std::vector<std::string>& names);
  std::string_view name() const override { return "hierarchy"; }

 private:
  bool takes(const Subproblem&) const override { return true; }
  Resolution do_solve(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop) const override;

  std::vector<std::unique_ptr<Solver>> solvers_;
};

}  // namespace accord
