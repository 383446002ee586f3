// One or more robots that move as one: the configuration space that a roadmap is laid in. A team
// of one is a robot on its own; larger teams are composite spaces, where all members depart and
// arrive together. Configurations are the members' numbers one after the other.
// Not thread safe (holds scratch); one per thread.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/moving_obstacles.h"

namespace accord {

class Team {
 public:
  // From the instant `from` (s) on. Requires: members are not empty, no repeats.
  Team(const CollisionWorld& world, std::vector<RobotId> members, double from);

  std::size_t dof() const { return dof_; }
  std::size_t size() const { return members_.size(); }
  RobotId member(std::size_t i) const { return members_[i]; }
  ConfigurationView part(ConfigurationView q, std::size_t i) const {
    return q.subspan(offsets_[i], offsets_[i + 1] - offsets_[i]);
  }
  std::span<double> mutable_part(std::span<double> q, std::size_t i) const {
    return q.subspan(offsets_[i], offsets_[i + 1] - offsets_[i]);
  }

  // All members have to avoid this robot until `until` (s).
  void avoid(RobotId other, const Trajectory& path,
             double until = std::numeric_limits<double>::infinity());
  // The team's only robot has to avoid a body that was made for it, which remembers what it is
  // asked. Requires: a team of one.
  void avoid(std::shared_ptr<MovingBody> body) { obstacles_[0].add(std::move(body)); }
  // And the discs and balls of `traffic`, or `only` some (see MovingObstacles). Requires: all
  // members are discs or balls.
  void avoid(const PointTraffic& traffic, const std::vector<char>* only = nullptr);
  // The outsiders of a subproblem, until its horizon.
  void avoid_outsiders(const Subproblem& subproblem);

  // Free of obstacles, of self-contact and of each other.
  bool is_free(ConfigurationView q) const;
  // Whether member i is, of the members before it too.
  bool is_free_beside(ConfigurationView q, std::size_t i) const;
  // Whether the members, each on its linear motion from a to b over the same time, are free of all
  // these at every instant. b's numbers are taken as written.
  bool motion_is_free(ConfigurationView a, ConfigurationView b) const;

  // Least time (s) in which all members can move linearly from a to b (numbers as written).
  double duration(ConfigurationView a, ConfigurationView b) const;
  // Squared distance in a metric that weighs each degree of freedom by how far it moves the body.
  double squared_distance(ConfigurationView a, ConfigurationView b) const;
  // b in the numbers nearest to a (see model/robot.h).
  void nearest_representation(ConfigurationView a, ConfigurationView b,
                              std::span<double> out) const;

  // As MovingObstacles, for all members at once.
  void safe_intervals(ConfigurationView q, double since, std::vector<Interval>& out,
                      const std::optional<MovingBody::Name>& name = std::nullopt);
  std::optional<double> earliest_departure(ConfigurationView a, ConfigurationView b,
                                           double duration, double lo, double hi);
  bool motion_is_clear(ConfigurationView a, ConfigurationView b, double t, double duration);
  // Whether all that members have to avoid in time is known in closed form.
  bool avoids_points() const;
  std::uint64_t checks() const;

 private:
  const CollisionWorld& world_;
  std::vector<RobotId> members_;
  std::vector<std::size_t> offsets_;
  std::size_t dof_ = 0;
  std::vector<double> weights_;  // per degree of freedom
  std::vector<char> wraps_;
  std::vector<MovingObstacles> obstacles_;  // one a member
  mutable std::vector<double> delta_;       // scratch
  std::vector<Interval> other_;             // scratch
  std::vector<Interval> merged_;            // scratch
};

}  // namespace accord
