// Cuts corners of a timed path among moving obstacles: a straight motion in place of a stretch, and
// everything after it earlier by what that saves. Works in any team's space, so that it serves
// single robots and composite paths alike (shortcutting as in Geraerts and Overmars 2007, in time).
#pragma once

#include <cstdint>

#include "common/model/trajectory.h"
#include "common/planning/subproblem.h"
#include "worker/team.h"

namespace accord {

// Tries seeded pairs of instants until that stops paying. The path stays free of everything that
// the team avoids; its start time, start and goal stay; resting at the goal stays free until
// `hold_until` (s). Never makes the path arrive later.
void cut_corners(Team& team, double hold_until, std::uint64_t seed, Trajectory& path,
                 Effort& effort);

}  // namespace accord
