// Adaptive Robot Coordination (Solis, Motes, Qin, Morales, Amato 2023), Algorithms 1 and 2: plans
// each robot alone, finds the conflicts between the paths, and solves a small local problem around
// each with as much coupling as it needs.
//
// Rounds: all subproblems of a round share no robots and are not near each other in time and space,
// so that they can be solved in any order, or at the same time, and committed in the order of their
// conflicts. A round's choice depends on the schedule alone; hence the plan does not depend on how
// many workers there are. What may be asked for next is guessed while they work (Forerunner).
//
// Progress: outsiders are moving obstacles of every subproblem, so that a commit makes no conflict
// earlier than the one it resolves. When no way among them is found, the window doubles and then
// the robots in the way are taken in, up to all robots, their whole queries and whole spaces.
#pragma once

#include <atomic>
#include <utility>
#include <vector>

#include "coordinator/adaptation.h"
#include "coordinator/method.h"
#include "coordinator/round.h"

namespace accord {

class Arc final : public Method {
 public:
  // As Method's.
  Arc(const CollisionWorld& planning, const CollisionWorld& detection, std::uint64_t seed,
      Workforce& workforce, const std::atomic<bool>& stop, ProgressCallback progress)
      : Method(planning, detection, seed, workforce, stop, std::move(progress)),
        adaptation_(factory_, schedule_) {}

 private:
  Outcome resolve(ConflictBoard& board) override;
  void solve(std::vector<Job>& jobs, const ConflictBoard& board);
  void find_robots_in_the_way(std::vector<Job>& jobs, const Foresight& foresight);
  void record(const Job& job);
  // One line a subproblem, for who wants to see why planning takes as long as it does.
  void log_job(const Job& job) const;

  Adaptation adaptation_;
};

}  // namespace accord
