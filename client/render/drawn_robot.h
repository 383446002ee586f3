// A robot of a scene as a picture shows it: with its colour and, where a plan has one, its path.
#pragma once

#include <string>
#include <vector>

#include "common/model/plan.h"
#include "common/model/scene.h"

namespace accord {

struct DrawnRobot {
  const Robot& robot;
  const Trajectory* path;  // nullptr: none
  std::string colour;
};

// All robots of the scene, which must outlive them as the plan must. `plan` may be null; paths that
// do not fit a robot of the scene are left out.
std::vector<DrawnRobot> drawn_robots(const Scene& scene, const Plan* plan);

// The way of the robot's traced point; arms move it along curves between waypoints.
// Requires: the robot has a path.
std::vector<Vec3> traced_way(const DrawnRobot& drawn);

}  // namespace accord
