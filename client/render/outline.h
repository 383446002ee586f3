// What shapes and robots look like from above or from the side.
#pragma once

#include <vector>

#include "common/model/configuration.h"
#include "common/model/robot.h"
#include "common/model/shape.h"

namespace accord {

enum class View {
  kTop,   // x to the right, y up
  kSide,  // x to the right, z up
};

Vec2 projected(View view, const Vec3& point);

// A polygon, or a circle about its only point where radius > 0. Metres.
struct Outline {
  std::vector<Vec2> points;
  double radius = 0;
};

// The shadow of a shape; of a mesh its convex hull. In a planar scene the plane's cut through it
// for every shape that formats.md allows there; without points where it misses the plane.
Outline outline(const Shape& shape, const Pose& pose, View view, bool planar);

// The frames of the robot's links at q.
std::vector<Pose> link_poses(const Robot& robot, ConfigurationView q);

std::vector<Outline> robot_outlines(const Robot& robot, ConfigurationView q, View view,
                                    bool planar);

// Where a mobile robot is; the base of an arm.
Vec3 standing_point(const Robot& robot, ConfigurationView q);

// The point whose way is drawn as the robot's path: where a mobile robot is; the far end of an
// arm's last body.
Vec3 traced_point(const Robot& robot, ConfigurationView q);

}  // namespace accord
