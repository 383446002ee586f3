// Whether any of many robots, each on its path, comes too close to another.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/model/trajectory.h"

namespace accord {

struct Mover {
  RobotId robot;
  const Trajectory* path;      // not empty; the robot is parked at its end
  double until;                // s: keeps clear of the others until then; may be infinite
  bool is_in_question = true;  // two that are not are not looked at
};

struct Meeting {
  std::size_t first;  // of the movers
  std::size_t second;
  double time;  // s: the two are clear of each other before it
};

// A meeting of two movers in [from, until], `until` being the earlier one of theirs; not always the
// earliest. nullopt is a proof that there is none, as earliest_contact()'s is.
// Few are compared each with each; of many, boxes of what they sweep in a while rule out most
// pairs, so that the cost hardly grows faster than their number.
// Pure; thread safe. Requires: all are of the world's scene, none twice.
std::optional<Meeting> find_meeting(const CollisionWorld& world, const std::vector<Mover>& movers,
                                    double from);

}  // namespace accord
