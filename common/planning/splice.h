// Putting paths together in time.
#pragma once

#include "common/model/robot.h"
#include "common/model/trajectory.h"

namespace accord {

// Two waypoints closer in time than this are one: a splice at a waypoint must not leave a sliver
// of a motion whose speed is all rounding.
inline constexpr double kSameInstant = 1e-9;  // s

// Goes on from the end of `path` as `old` does after the instant `cut` (s), moved in time so that
// it follows at once. `path` ends where `old` is at `cut`, up to whole turns of degrees of freedom
// that wrap: the rest goes on in the turns that `path` ended in.
void append_tail(const RobotModel& model, const Trajectory& old, double cut, Trajectory& path);

}  // namespace accord
