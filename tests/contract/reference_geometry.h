// Distances and kinematics as a textbook has them, slow and independent of common/geometry: what
// its certificates are held against.
//
// Distances between convex sets come from alternating projections, which give an upper bound (the
// distance of two points), and from the sets' supports along the line between these points, which
// gives a lower one. Both are true whether or not the iteration converged.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/model/scene.h"

namespace accord::reference {

class ConvexSet {
 public:
  virtual ~ConvexSet() = default;
  virtual Vec3 project(const Vec3& p) const = 0;  // the set's point closest to p
  virtual Vec3 support(const Vec3& d) const = 0;  // the set's point farthest along d
};

using Sets = std::vector<std::unique_ptr<ConvexSet>>;

struct Bracket {
  double lower;
  double upper;
};

Bracket distance(const ConvexSet& a, const ConvexSet& b, double cutoff = 1e300);
Bracket distance(const Sets& a, const Sets& b, double cutoff = 1e300);

// A shape as convex sets. Planar: its cut with z = 0, for poses without roll, pitch and height
// (anything that a cylinder or a box may do upright); non-convex polygons are their edges, meshes
// their triangles.
Sets sets_of(const Shape& shape, const Pose& pose, bool planar);

// World poses of the robot's links, by multiplying matrices.
std::vector<Pose> link_poses(const Robot& robot, ConfigurationView q);

// Bodies of a robot at q.
std::vector<Sets> bodies(const Scene& scene, RobotId robot, ConfigurationView q);
Sets obstacles(const Scene& scene);

Bracket robot_distance(const Scene& scene, RobotId a, ConfigurationView qa, RobotId b,
                       ConfigurationView qb);
Bracket obstacle_distance(const Scene& scene, RobotId robot, ConfigurationView q);
Bracket self_distance(const Scene& scene, RobotId robot, ConfigurationView q);

// a + u (b - a)
Configuration between(ConfigurationView a, ConfigurationView b, double u);

}  // namespace accord::reference
