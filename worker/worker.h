// What a worker does: solves subproblems of one scene, of whatever kind. The only thing that a
// coordinator needs of it.
// Thread safe.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/workspace.h"

namespace accord {

class Worker {
 public:
  // The world must outlive this.
  explicit Worker(const CollisionWorld& world) : workspace_(world) {}

  // A robot on its own is given its path; a team goes through the solvers, in order. What comes
  // back depends on the two alone, unless `stop` becomes true, which ends the attempt unsolved
  // soon. Requires: names that make_solver() knows.
  Resolution solve(const Subproblem& subproblem, const std::vector<std::string>& solvers,
                   const std::atomic<bool>& stop) const;

 private:
  Workspace workspace_;
};

}  // namespace accord
