// The geometry of a scene, made ready for queries: what touches what, how far apart things are, and
// proofs that motions are free at every instant. The one place that planner and verifier share.
//
// What a proof stands on: every distance used is exact (closed forms) or a lower bound that holds
// whether or not the algorithm behind it converged (a separating direction, evaluated), less a
// bound on rounding; and every motion is advanced by no more than that distance allows, given a
// bound on how fast any point of a body moves (conservative advancement; Mirtich 1996, Schwarzer,
// Saha and Latombe 2005), or decided in closed form (discs and balls on linear motions).
// "Free" is therefore a proof. "Not free" may be wrong by up to `margin` + kContactResolution.
//
// Units: metres, radians, seconds; world frame. Configurations are in the order of formats.md.
// Thread safety: immutable after construction; all const members may be called concurrently.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/model/ids.h"
#include "common/model/scene.h"

namespace accord {

// A robot's linear motion: at `from` when t0, at `to` when t1. from == to is a rest.
struct Motion {
  ConfigurationView from;
  ConfigurationView to;
  double t0;  // s
  double t1;  // s, > t0
};

struct Aabb {
  Vec3 min;
  Vec3 max;

  bool overlaps(const Aabb& other) const {
    return (min.array() <= other.max.array()).all() && (other.min.array() <= max.array()).all();
  }
  void merge(const Aabb& other) {
    min = min.cwiseMin(other.min);
    max = max.cwiseMax(other.max);
  }
};

// What is wrong with a configuration, for messages to people.
struct Fault {
  enum class Kind { kLimit, kBounds, kObstacle, kSelf, kRobot };
  Kind kind;
  std::string body;   // the robot's body (or degree of freedom, for kLimit)
  std::string other;  // obstacle, other body, or "robot: body"; empty for kLimit and kBounds
  double gap;         // m: separation where positive, else minus an estimate of the overlap; for
                      // kLimit and kBounds minus the excess
  Vec3 where;         // near the place; world frame
};

class CollisionWorld {
 public:
  // `margin` (m) is kept in addition to the scene's clearance from obstacles and other robots, and
  // from self-contact. Planning uses kPlanningMargin, the verifier kProofMargin.
  // Requires: the scene passed io's checks of shapes (positive sizes, simple polygons).
  explicit CollisionWorld(std::shared_ptr<const Scene> scene, double margin);
  ~CollisionWorld();
  CollisionWorld(const CollisionWorld&) = delete;
  CollisionWorld& operator=(const CollisionWorld&) = delete;

  const Scene& scene() const { return *scene_; }

  // ---- One robot against limits, bounds, obstacles and itself ----

  bool is_free(RobotId robot, ConfigurationView q) const;

  // The worst fault of a configuration, nullopt where is_free() holds. Slower; for messages. Knows
  // about the inside of closed meshes too.
  std::optional<Fault> fault(RobotId robot, ConfigurationView q) const;

  // Whether the linear motion from a to b is free at every instant. Symmetric in a and b.
  bool motion_is_free(RobotId robot, ConfigurationView a, ConfigurationView b) const;

  // The fraction in [0, 1] up to which the motion is proved free; nullopt when all of it is.
  std::optional<double> first_fault(RobotId robot, ConfigurationView a, ConfigurationView b) const;

  // A lower bound on the distance between the robot's bodies and the obstacles, tight to 1e-6;
  // 0 where they touch; at most `cutoff` (m), which saves work.
  double obstacle_distance(RobotId robot, ConfigurationView q, double cutoff) const;

  // ---- Two robots ----

  // A lower bound on the distance between two robots' bodies, tight to 1e-6; 0 where they touch;
  // at most `cutoff` (m).
  double separation(RobotId a, ConfigurationView qa, RobotId b, ConfigurationView qb,
                    double cutoff) const;

  // Whether two robots at rest keep clearance and margin.
  bool are_clear(RobotId a, ConfigurationView qa, RobotId b, ConfigurationView qb) const;

  // The names of the closest bodies of two robots, for messages; kind is kRobot.
  Fault closest(RobotId a, ConfigurationView qa, RobotId b, ConfigurationView qb) const;

  // The instant (s) up to which two robots on linear motions are proved to keep clearance and
  // margin; nullopt when they do for all of [t0, t1].
  // Requires: both motions have the same t0 and t1.
  std::optional<double> first_contact(RobotId a, const Motion& motion_a, RobotId b,
                                      const Motion& motion_b) const;

  // Whether two robots keep clearance and margin at every instant of linear motions over the same
  // time. As first_contact(), but does not look for the first one, which takes longer.
  bool motions_are_clear(RobotId a, ConfigurationView from_a, ConfigurationView to_a, RobotId b,
                         ConfigurationView from_b, ConfigurationView to_b) const;

  // The distance that two robots' bodies must keep: clearance + margin.
  double required_separation() const;

  // ---- Extents, for broad phases and metrics ----

  // Holds every body throughout the linear motion from a to b; not inflated by the clearance.
  Aabb swept_bounds(RobotId robot, ConfigurationView a, ConfigurationView b) const;

  // How far a point of the robot can move per unit of each degree of freedom (m/rad, or 1):
  // the weights of a metric, and of bounds on motion.
  std::span<const double> reach(RobotId robot) const;

  // For discs and balls, whose configuration is their centre: the radius. nullopt for the rest.
  std::optional<double> radius(RobotId robot) const;

  // Distances between two convex pieces worked out so far, over all threads: closed forms, for
  // instants or whole motions, and iterations (a mesh counts as one piece). For statistics.
  std::uint64_t distance_queries() const;

  // Adds those that a caller has worked out itself, as discs and balls allow: see DistanceTally.
  void count_distance_queries(std::uint64_t n) const;

 private:
  struct Impl;
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<Impl> impl_;
  double margin_;
};

}  // namespace accord
