// Adaptive Robot Coordination (Solis, Motes, Qin, Morales, Amato 2023), Algorithms 1 and 2: plans
// each robot alone, finds the conflicts between the paths, and solves a small local problem around
// each with as much coupling as it needs.
//
// Rounds: all subproblems of a round share no robots and are not near each other in time and space,
// so that they can be solved in any order, or at the same time, and committed in the order of their
// conflicts. A round's choice depends on the schedule alone; hence the plan does not depend on how
// many workers there are.
//
// Progress: outsiders are moving obstacles of every subproblem, so that a commit makes no conflict
// earlier than the one it resolves. When no way among them is found, the window doubles and then
// the robots in the way are taken in, up to all robots, their whole queries and whole spaces.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/schedule.h"
#include "coordinator/adaptation.h"
#include "coordinator/conflict_board.h"
#include "coordinator/method.h"
#include "coordinator/progress.h"
#include "coordinator/subproblem_factory.h"
#include "coordinator/workforce.h"

namespace accord {

class Arc final : public Method {
 public:
  // Two worlds of the same scene: conflicts are looked for with a smaller margin than planning
  // keeps, so that what planning avoids is not found to be a conflict again for rounding.
  Arc(const CollisionWorld& planning, const CollisionWorld& detection, std::uint64_t seed,
      Workforce& workforce, const std::atomic<bool>& stop, ProgressCallback progress);

  Outcome run() override;
  const Schedule& schedule() const override { return schedule_; }
  const PlanningStatistics& statistics() const override { return statistics_; }

 private:
  struct Job {
    Conflict conflict;
    Subproblem subproblem;
    Resolution resolution;
    std::vector<RobotId> in_the_way;  // of an exhausted one: outsiders to take in
  };

  void commit(const Job& job, ConflictBoard& board);
  static bool is_left(const Job& job);
  std::vector<Job> choose(const ConflictBoard& board) const;
  void solve(std::vector<Job>& jobs);
  void find_robots_in_the_way(std::vector<Job>& jobs);
  std::vector<RobotId> hit_by(const Job& job, const Resolution& resolution) const;
  void record(const Job& job);
  // One line a subproblem, for who wants to see why planning takes as long as it does.
  void log(const Job& job) const;
  void report(Progress::Phase phase);
  const Scene& scene() const { return planning_.scene(); }

  const CollisionWorld& planning_;
  const CollisionWorld& detection_;
  Workforce& workforce_;
  const std::atomic<bool>& stop_;
  ProgressCallback progress_;
  SubproblemFactory factory_;
  Schedule schedule_;
  Adaptation adaptation_;
  PlanningStatistics statistics_;
};

}  // namespace accord
