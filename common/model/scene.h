// A planning problem: environment, robots, queries (each robot's start and goal), timestep and
// clearance. Immutable; safe to share between threads. Units: metres, radians, seconds.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/model/ids.h"
#include "common/model/robot.h"
#include "common/model/shape.h"

namespace accord {

struct Bounds {
  Vec3 min;  // planar scenes: z unused
  Vec3 max;
};

struct Obstacle {
  std::string name;  // never empty: the file's, or made from its place ("obstacle 3 (box)")
  Shape shape;
  Pose pose;
};

struct Scene {
  std::string name;
  double timestep = 0.1;   // s, > 0
  double clearance = 0.0;  // m, >= 0: kept from obstacles and other robots; at 0 touching collides
  bool planar = false;     // everything lies in z = 0 and shapes mean their cut with it
  std::optional<Bounds> bounds;
  std::vector<Obstacle> obstacles;
  std::vector<Robot> robots;

  const Robot& robot(RobotId id) const { return robots[id.index()]; }
};

}  // namespace accord
