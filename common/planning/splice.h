// Putting paths together in time.
#pragma once

#include "common/model/robot.h"
#include "common/model/trajectory.h"

namespace accord {

// Two waypoints closer in time than this are one: a splice at a waypoint must not leave a sliver
// of a motion whose speed is all rounding.
inline constexpr double kSameInstant = 1e-9;  // s

// Appends a waypoint at t (s) or, where that is hardly later than the path's end or no longer is
// for rounding, an instant after it. Returns the time that it was given. Requires: path is not
// empty.
double append_apart(double t, ConfigurationView q, Trajectory& path);

// Goes on from the end of `path` as `old` does after the instant `cut` (s), moved in time so that
// it follows at once. `path` ends where `old` is at `cut`, up to whole turns of degrees of freedom
// that wrap: the rest goes on in the turns that `path` ended in.
void append_tail(const RobotModel& model, const Trajectory& old, double cut, Trajectory& path);

}  // namespace accord
