// The earliest conflict of every pair of robots in the present schedule, kept up to date: after a
// change only pairs with a changed robot are scanned again, and only from the change on.
// (Alg. 1, lines 6 and 11: FindConflict)
// Not thread safe.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
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

  bool empty() const { return conflicts_.empty(); }
  std::size_t size() const { return conflicts_.size(); }
  // All, by time, then by pair.
  std::vector<Conflict> conflicts() const;

  const SpaceTimeGrid& grid() const { return grid_; }
  // Pieces of trajectory pairs looked at exactly so far.
  std::uint64_t pair_checks() const { return pair_checks_; }

 private:
  using Pair = std::pair<RobotId, RobotId>;

  void scan(RobotId robot, double from);

  const CollisionWorld& world_;
  const Schedule& schedule_;
  SpaceTimeGrid grid_;
  std::map<Pair, double> conflicts_;
  std::vector<char> scanned_;  // by robot: already scanned in this update
  std::uint64_t pair_checks_ = 0;
};

}  // namespace accord
