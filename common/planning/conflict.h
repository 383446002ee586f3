// Where two robots' paths interfere: <c_i, c_j, t> of the ARC paper, section III.
#pragma once

#include <optional>

#include "common/model/ids.h"
#include "common/model/trajectory.h"

namespace accord {

class CollisionWorld;

// The earliest instant at which two robots come closer than the world's required separation.
struct Conflict {
  RobotId first;  // first < second, so that a pair has one name
  RobotId second;
  double time;  // s: everything before is proved free
};

// Finds the earliest conflict of two trajectories in [from, until] (s); `until` may be infinite,
// robots park at their ends. nullopt is a proof that there is none at any instant: see
// CollisionWorld for what the proof stands on. Pure; thread safe.
// Requires: both trajectories belong to the world's scene and are not empty. (Alg. 1, lines 6, 11)
std::optional<double> earliest_contact(const CollisionWorld& world, RobotId a,
                                       const Trajectory& path_a, RobotId b,
                                       const Trajectory& path_b, double from, double until);

// Whether there is none: as earliest_contact(), but does not look for the first, which takes
// longer.
bool paths_are_clear(const CollisionWorld& world, RobotId a, const Trajectory& path_a, RobotId b,
                     const Trajectory& path_b, double from, double until);

}  // namespace accord
