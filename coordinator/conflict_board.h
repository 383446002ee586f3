// The earliest conflict of every pair of robots in the present schedule, kept up to date: after a
// change only pairs with a changed robot are scanned again, and only from the change on. Looks as
// far ahead in time as it is asked to: what lies far ahead will have changed before its turn.
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
  // Has looked at nothing yet. Requires: every robot has a path.
  ConflictBoard(const CollisionWorld& world, const Schedule& schedule);

  // A copy for a copy of the schedule. Requires: `schedule` equals the other board's.
  ConflictBoard(const ConflictBoard& other, const Schedule& schedule);

  // Looks further ahead until `enough` conflicts are known and it has seen `reach` (s) beyond the
  // earliest, or all there is. False: there is no conflict at any time.
  bool look_ahead(std::size_t enough, double reach);
  // All there is.
  bool look_at_all();
  // Up to when (s) conflicts are known; infinite where all are.
  double seen_until() const;

  // Scans again what the given robots' new paths may have changed from time `from` (s) on, as far
  // as it has looked ahead.
  void update(const std::vector<RobotId>& changed, double from);

  struct Earlier {
    bool operator()(const Conflict& a, const Conflict& b) const {
      return std::tie(a.time, a.first, a.second) < std::tie(b.time, b.first, b.second);
    }
  };

  std::size_t size() const { return by_time_.size(); }
  // The conflicts come upon so far: of those that changes brought, as many as outnumber those that
  // they took away.
  std::uint64_t found() const { return found_; }
  // All that are known, by time, then by pair. Valid until the next update.
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
  void scan(RobotId robot, double from, std::size_t first_slab, std::size_t last_slab);
  void scan(const std::vector<RobotId>& robots, double from, std::size_t first_slab,
            std::size_t last_slab);
  void add(const Conflict& conflict);

  const CollisionWorld& world_;
  const Schedule& schedule_;
  SpaceTimeGrid grid_;
  std::set<Conflict, Earlier> by_time_;
  std::vector<std::vector<WithOther>> by_robot_;  // the same
  std::vector<char> is_done_;                     // scratch, by robot: needs no further look
  std::size_t looked_ = 0;                        // slabs that have been looked at
  std::uint64_t found_ = 0;
  std::uint64_t pair_checks_ = 0;
};

}  // namespace accord
