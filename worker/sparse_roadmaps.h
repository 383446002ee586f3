// A roadmap a robot for searches that branch on nodes and edges: its guide as a chain, and samples
// joined to their neighbours, so that no two edges are the same motion.
// Not thread safe.
#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/local_roadmap.h"

namespace accord {

class SparseRoadmaps {
 public:
  static constexpr LocalRoadmap::Node kStart = 0;
  static constexpr LocalRoadmap::Node kGoal = 1;

  // With so many free samples each. A task's guide leads from its start to its goal.
  SparseRoadmaps(const CollisionWorld& world, const Subproblem& subproblem, std::size_t samples);

  LocalRoadmap& of(std::size_t task) { return roadmaps_[task]; }
  std::uint64_t motion_checks() const;

 private:
  std::vector<LocalRoadmap> roadmaps_;  // by task
};

}  // namespace accord
