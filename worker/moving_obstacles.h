// What a robot must avoid in time: other robots on known paths. Answers the two questions that
// safe-interval planning asks (Phillips and Likhachev 2011): when may a robot rest at a
// configuration, and when is the earliest instant it may set out on a motion.
// Answers are certificates: rests and motions that they allow are free at every instant.
// Not thread safe (holds scratch); one per thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/geometry/distance_tally.h"
#include "common/model/trajectory.h"
#include "worker/interval.h"
#include "worker/moving_body.h"
#include "worker/point_traffic.h"

namespace accord {

class MovingObstacles {
 public:
  // Time (s) kept from the instants at which contact would begin or end. Without it, paths would
  // graze what they avoid to the last bit, and cut anew they would be found to touch it.
  static constexpr double kSlack = 1e-3;

  // For `robot`, from the instant `from` (s) on.
  MovingObstacles(const CollisionWorld& world, RobotId robot, double from);

  // Adds another robot, which parks at its path's end. It is avoided until `until` (s, may be
  // infinite), but if it has parked by then, for good: else waiting for it to vanish would seem a
  // way past it. Copies what it needs.
  void add(RobotId other, const Trajectory& path, double until);
  // Adds a body that was made for this robot. Others may hold it, too, so that it remembers what it
  // was asked.
  void add(std::shared_ptr<MovingBody> body) { bodies_.push_back(std::move(body)); }
  // Adds all discs and balls of `traffic`, or `only` those of owners o that only[o] holds for. Both
  // must outlive this. Requires: the robot is a disc or a ball.
  void add(const PointTraffic& traffic, const std::vector<char>* only = nullptr);

  // The times from `since` (s) on, and not before `from`, at which resting at q is free, in order,
  // disjoint. Empty: never. `name`: by which bodies remember q.
  void safe_intervals(ConfigurationView q, double since,
                      const std::optional<MovingBody::Name>& name, std::vector<Interval>& out);

  // The earliest departure in [lo, hi] from which the linear motion from a to b, taking `duration`
  // (s, > 0), is free. nullopt: none was found. For discs and balls exact; for other bodies
  // departures are tried in growing steps, so that a narrow opening can be missed, never a contact.
  std::optional<double> earliest_departure(ConfigurationView a, ConfigurationView b,
                                           double duration, double lo, double hi);

  // Whether the linear motion from a at t to b at t + duration is free.
  bool motion_is_clear(ConfigurationView a, ConfigurationView b, double t, double duration);

  // Whether there are only discs and balls to avoid, by one: answers are closed forms.
  bool is_of_points() const { return bodies_.empty(); }

  // Geometric queries made so far; none for discs and balls among themselves.
  std::uint64_t checks() const;

 private:
  using Points = std::vector<const PointTraffic::Piece*>;

  void add_points(const Trajectory& path, double radius, double until);
  // The discs and balls that a motion from a to b can meet between `since` and `until` (s). Valid
  // until the next call.
  const Points& points_near(ConfigurationView a, ConfigurationView b, double since, double until);
  // What centres must keep.
  double distance_to(const PointTraffic::Piece& piece) const {
    return own_distance_ + piece.radius;
  }
  void point_unsafe(const Points& points, ConfigurationView q, std::vector<Interval>& unsafe) const;
  double point_next_departure(const Points& points, const Vec3& a, const Vec3& velocity,
                              double duration, double t) const;
  double last_unsafe_departure(const PointTraffic::Piece& piece, const Vec3& a,
                               const Vec3& velocity, double duration) const;
  MovingBody::Passage past_bodies(ConfigurationView a, ConfigurationView b, double t,
                                  double duration);

  const CollisionWorld& world_;
  RobotId robot_;
  double from_;
  double own_distance_;  // m: what centres must keep, less the other's radius
  std::vector<PointTraffic::Piece> points_;
  std::vector<Aabb> reaches_;  // of the same: where centres may come too near
  std::vector<std::shared_ptr<MovingBody>> bodies_;
  std::vector<std::pair<const PointTraffic*, const std::vector<char>*>> traffic_;
  mutable DistanceTally tally_;
  std::vector<Interval> unsafe_;  // scratch
  Points near_;                   // scratch
};

}  // namespace accord
