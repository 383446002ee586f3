// What the verifier's checks share: the scene, its geometry, and the plan's paths in the scene's
// order, once the plan's form is known to be good. Internal to the verifier. Read-only throughout.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/model/scene.h"
#include "common/model/trajectory.h"

namespace accord::verification {

struct Subject {
  const Scene& scene;
  const CollisionWorld& world;
  std::vector<const Trajectory*> paths;  // by RobotId, all with at least one waypoint

  std::size_t robots() const { return paths.size(); }
  const Trajectory& path(RobotId id) const { return *paths[id.index()]; }
  const Robot& robot(RobotId id) const { return scene.robot(id); }

  // When the last robot parks (s).
  double end() const {
    double latest = 0;
    for (const Trajectory* path : paths) latest = std::max(latest, path->end_time());
    return latest;
  }
};

// Where a robot is, for messages: the position of a mobile robot, the base of an arm.
Vec3 place_of(const Robot& robot, ConfigurationView q);

// How far any point of the robot moves at most (m) on the linear motion from a to b.
double travel(const CollisionWorld& world, RobotId id, ConfigurationView a, ConfigurationView b);

// Calls visit(t0, t1) for the successive stretches of [begin, end] (s) on which both paths are
// linear, t0 < t1, until it returns false.
template <typename Visit>
void for_each_stretch(const Trajectory& a, const Trajectory& b, double begin, double end,
                      Visit&& visit) {
  const auto next_after = [](const Trajectory& path, double t) {
    return std::upper_bound(path.times().begin(), path.times().end(), t);
  };
  auto next_a = next_after(a, begin);
  auto next_b = next_after(b, begin);
  for (double t0 = begin; t0 < end;) {
    double t1 = end;
    if (next_a != a.times().end()) t1 = std::min(t1, *next_a);
    if (next_b != b.times().end()) t1 = std::min(t1, *next_b);
    if (!visit(t0, t1)) return;
    while (next_a != a.times().end() && *next_a <= t1) ++next_a;
    while (next_b != b.times().end() && *next_b <= t1) ++next_b;
    t0 = t1;
  }
}

}  // namespace accord::verification
