// Plans one robot on its own: straight if that is free, else on its roadmap; then shortens the path
// and times it at the robot's limits. (Alg. 1, line 3: MotionPlanning)
// Thread safe.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/robot_roadmap.h"

namespace accord {

class PathPlanner {
 public:
  static constexpr std::string_view kStraight = "straight";
  static constexpr std::string_view kRoadmap = "prm";

  explicit PathPlanner(const CollisionWorld& world);

  // The path of a subproblem's only robot from start to goal, from the window's start on; not
  // solved when the largest roadmap holds none. Depends on scene and subproblem alone.
  // Requires: one task, no outsiders.
  Resolution plan(const Subproblem& subproblem, const std::atomic<bool>& stop) const;

 private:
  const CollisionWorld& world_;
  std::vector<std::shared_ptr<RobotRoadmap>> roadmaps_;  // by robot; shared
};

// Shortens a free path in place: jumps to the furthest waypoint in straight reach, then cuts
// corners at seeded places until that stops paying. Stays free; ends stay.
void shorten_alone(const CollisionWorld& world, RobotId robot, std::uint64_t seed,
                   std::vector<Configuration>& path, Effort& effort);

}  // namespace accord
