// The local roadmaps of a subproblem's robots, each in its own configuration space: start, goal,
// the robot's own roadmap as far as it lies in the region, the guide's waypoints and points between
// them, and samples of the region. Each is built when it is first asked for.
// Not thread safe; lives as long as one solution attempt.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "common/planning/subproblem.h"
#include "worker/local_roadmap.h"
#include "worker/team.h"
#include "worker/workspace.h"

namespace accord {

class DecoupledRoadmaps {
 public:
  // A robot's start and goal in its roadmap.
  static LocalRoadmap::Node start(const LocalRoadmap& roadmap) { return roadmap.first_own(); }
  static LocalRoadmap::Node goal(const LocalRoadmap& roadmap) { return roadmap.first_own() + 1; }

  DecoupledRoadmaps(const Workspace& workspace, const Subproblem& subproblem);

  // Every robot's roadmap gets up to `count` more free samples of its region (Halton points, seeded
  // by the subproblem), connected to their neighbours. References from of() stay valid.
  void add_samples(std::size_t count) { samples_wanted_ += count; }

  LocalRoadmap& of(std::size_t task);
  // Has a team of that task's robot avoid another robot until `until` (s). What is asked of the
  // same robot on the same path again is remembered.
  void avoid(std::size_t task, RobotId other, const Trajectory& path, double until, Team& team);
  void avoid_outsiders(std::size_t task, Team& team);

  // Of the roadmaps that were asked for:
  std::uint64_t samples() const { return samples_; }
  std::uint64_t motion_checks() const;

 private:
  struct Entry {
    LocalRoadmap roadmap;
    std::size_t samples = 0;                               // asked for
    std::uint64_t next_sample = 0;                         // index into the robot's Halton sequence
    std::vector<std::shared_ptr<MovingBody>> bodies = {};  // met so far, for this robot
  };

  LocalRoadmap build(const Team& team, const Task& task) const;
  void sample(const Team& team, const Task& task, Entry& entry);

  const Workspace& workspace_;
  const Subproblem& subproblem_;
  std::vector<std::optional<Entry>> entries_;  // by task
  std::size_t samples_wanted_ = 0;
  std::uint64_t samples_ = 0;
};

}  // namespace accord
