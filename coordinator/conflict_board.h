// The earliest conflict of every pair of robots in the present schedule, kept up to date: after a
// change only pairs with a changed robot are scanned again, and only from the change on.
// (Alg. 1, lines 6 and 11: FindConflict)
// Not thread safe.
#pragma once

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/conflict.h"
#include "common/planning/schedule.h"
#include "coordinator/space_time_grid.h"

namespace accord {

class ConflictBoard {
 public:
  // Scans the whole schedule. Requires: every robot has a path.
  ConflictBoard(const CollisionWorld& world, const Schedule& schedule);

  // Scans again what the given robots' new paths may have changed from time `from` (s) on.
  void update(const std::vector<RobotId>& changed, double from);

  struct Earlier {
    bool operator()(const Conflict& a, const Conflict& b) const {
      return std::tie(a.time, a.first, a.second) < std::tie(b.time, b.first, b.second);
    }
  };

  bool empty() const { return by_time_.empty(); }
  std::size_t size() const { return by_time_.size(); }
  // All, by time, then by pair. Valid until the next update.
  const std::set<Conflict, Earlier>& conflicts() const { return by_time_; }

  // Those of one robot, in no particular order. Valid until the next update.
  struct WithOther {
    RobotId other;
    double time;  // s
  };
  const std::vector<WithOther>& conflicts_of(RobotId robot) const {
    return by_robot_[robot.index()];
  }

  const SpaceTimeGrid& grid() const { return grid_; }
  // Pieces of trajectory pairs looked at exactly so far.
  std::uint64_t pair_checks() const { return pair_checks_; }

 private:
  void forget(RobotId robot, double from);
  void scan(RobotId robot, double from);
  void add(const Conflict& conflict);

  const CollisionWorld& world_;
  const Schedule& schedule_;
  SpaceTimeGrid grid_;
  std::set<Conflict, Earlier> by_time_;
  std::vector<std::vector<WithOther>> by_robot_;  // the same
  std::vector<char> is_done_;                     // scratch, by robot: needs no further look
  std::uint64_t pair_checks_ = 0;
};

}  // namespace accord
