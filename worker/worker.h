// What a worker does: solves subproblems of one scene, of whatever kind. The only thing that a
// coordinator needs of it.
// Thread safe.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/path_planner.h"
#include "worker/solver.h"

namespace accord {

class Worker {
 public:
  // `solvers`: the hierarchy, in order. Requires: names of local_solver_names().
  Worker(const CollisionWorld& world, const std::vector<std::string>& solvers)
      : world_(world), path_planner_(world), hierarchy_(solvers) {}

  // A robot on its own is given its path; a team goes through the hierarchy.
  Resolution solve(const Subproblem& subproblem, const std::atomic<bool>& stop) const;

 private:
  const CollisionWorld& world_;
  PathPlanner path_planner_;
  SolverHierarchy hierarchy_;
};

}  // namespace accord
