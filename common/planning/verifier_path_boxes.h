// Boxes that hold all that one robot sweeps during any stretch of its path. What a question costs
// grows with the logarithm of the path's length.
// Internal to the verifier. Immutable; thread safe. The world and the path must outlive it.
#pragma once

#include <vector>

#include "common/geometry/collision_world.h"
#include "common/model/trajectory.h"

namespace accord::verification {

class PathBoxes {
 public:
  PathBoxes(const CollisionWorld& world, RobotId robot, const Trajectory& path);

  // During [t0, t1] (s), t0 <= t1; the robot is parked at the path's end.
  Aabb over(double t0, double t1) const;

 private:
  // Of the motions from waypoint `first` to waypoint `last`. Requires: first < last.
  Aabb between(std::size_t first, std::size_t last) const;

  const CollisionWorld& world_;
  RobotId robot_;
  const Trajectory& path_;
  // levels_[k][i]: of the 2^k motions from waypoint 2^k i on.
  std::vector<std::vector<Aabb>> levels_;
};

}  // namespace accord::verification
