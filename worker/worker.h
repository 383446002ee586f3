// What a worker does: solves subproblems of one scene, of whatever kind. The only thing that a
// coordinator needs of it.
// Thread safe.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/solver.h"
#include "worker/workspace.h"

namespace accord {

class Worker {
 public:
  // `solvers`: the hierarchy, in order. Requires: names of local_solver_names().
  Worker(const CollisionWorld& world, const std::vector<std::string>& solvers)
      : workspace_(world), hierarchy_(solvers) {}

  // A robot on its own is given its path; a team goes through the hierarchy.
  Resolution solve(const Subproblem& subproblem, const std::atomic<bool>& stop) const;

 private:
  Workspace workspace_;
  SolverHierarchy hierarchy_;
};

}  // namespace accord
