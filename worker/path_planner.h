// Plans one robot on its own: straight if that is free, else on its roadmap; then shortens the path
// and times it at the robot's limits. (Alg. 1, line 3: MotionPlanning)
// Thread safe.
#pragma once

#include <atomic>
#include <cstdint>
#include <string_view>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/workspace.h"

namespace accord {

inline constexpr std::string_view kStraight = "straight";
inline constexpr std::string_view kRoadmap = "prm";

// The path of a subproblem's only robot from start to goal, from the window's start on; not solved
// when the largest roadmap holds none. Depends on scene and subproblem alone.
// Requires: one task, no outsiders.
Resolution plan_alone(const Workspace& workspace, const Subproblem& subproblem,
                      const std::atomic<bool>& stop);

// Shortens a free path in place: jumps to the furthest waypoint in straight reach, then cuts
// corners at seeded places until that stops paying. Stays free; ends stay.
void shorten_alone(const CollisionWorld& world, RobotId robot, std::uint64_t seed,
                   std::vector<Configuration>& path, Effort& effort);

}  // namespace accord
