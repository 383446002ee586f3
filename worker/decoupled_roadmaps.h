// The local roadmaps of a subproblem's robots, each in its own configuration space: start, goal,
// the robot's own roadmap as far as it lies in the region, the guide's waypoints and points between
// them, and samples of the region.
// Not thread safe; lives as long as one solution attempt.
#pragma once

#include <vector>

#include "common/planning/subproblem.h"
#include "worker/local_roadmap.h"
#include "worker/team.h"
#include "worker/workspace.h"

namespace accord {

class DecoupledRoadmaps {
 public:
  static constexpr LocalRoadmap::Node kStart = 0;
  static constexpr LocalRoadmap::Node kGoal = 1;

  DecoupledRoadmaps(const Workspace& workspace, const Subproblem& subproblem);

  // Adds up to `count` free samples of its region to every robot's roadmap (Halton points, seeded
  // by the subproblem), connected to their neighbours.
  void add_samples(const CollisionWorld& world, std::size_t count);

  LocalRoadmap& of(std::size_t task) { return roadmaps_[task]; }
  std::uint64_t samples() const { return samples_; }
  std::uint64_t motion_checks() const;

 private:
  void join_ends(const Team& team, LocalRoadmap& roadmap);
  void lay_guide(const Team& team, LocalRoadmap& roadmap, const Task& task);

  const Subproblem& subproblem_;
  std::vector<LocalRoadmap> roadmaps_;
  std::vector<std::uint64_t> next_sample_;  // index into each robot's Halton sequence
  std::uint64_t samples_ = 0;
};

}  // namespace accord
