#include "common/planning/conflict.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/collision_world.h"
#include "common/geometry/distance_tally.h"
#include "common/geometry/point_motion.h"

namespace accord {
namespace {

// The next waypoint time of a path after segment i; infinite past the end.
double next_time(const Trajectory& path, std::size_t i) {
  return i + 1 < path.size() ? path.time(i + 1) : std::numeric_limits<double>::infinity();
}

// Moves i on so that it is the segment of time t. Cheap where t only grows.
void follow(const Trajectory& path, std::size_t& i, double t) {
  while (i + 1 < path.size() && path.time(i + 1) <= t) ++i;
}

// A point robot's position and velocity on segment i.
struct PointState {
  Vec3 position = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
};

PointState point_state(const Trajectory& path, std::size_t i, double t) {
  PointState state;
  const ConfigurationView from = path.configuration(i);
  const bool moving = i + 1 < path.size() && t >= path.time(i);
  const double span = moving ? path.time(i + 1) - path.time(i) : 1;
  for (std::size_t k = 0; k < path.dof(); ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    state.position[axis] = from[k];
    if (!moving) continue;
    state.velocity[axis] = (path.configuration(i + 1)[k] - from[k]) / span;
    state.position[axis] += (t - path.time(i)) * state.velocity[axis];
  }
  return state;
}

std::optional<double> earliest_point_contact(const Trajectory& a, const Trajectory& b,
                                             double distance, double from, double until,
                                             DistanceTally& tally) {
  std::size_t i = a.segment_at(from), j = b.segment_at(from);
  double t = from;
  while (true) {
    const double end = std::min({next_time(a, i), next_time(b, j), until});
    const PointState at_a = point_state(a, i, t), at_b = point_state(b, j, t);
    const Vec3 offset = at_b.position - at_a.position;
    tally.add(1);
    if (std::isinf(end)) {
      return offset.squaredNorm() < distance * distance ? std::optional(t) : std::nullopt;
    }
    const double span = end - t;
    const Vec3 drift = (at_b.velocity - at_a.velocity) * span;
    if (const auto u = first_within(offset, drift, distance)) return t + *u * span;
    if (end >= until) return std::nullopt;
    t = end;
    follow(a, i, t);
    follow(b, j, t);
  }
}

// Two trajectories side by side: the pieces on which both move linearly.
class Sweep {
 public:
  Sweep(const CollisionWorld& world, RobotId a, const Trajectory& path_a, RobotId b,
        const Trajectory& path_b)
      : world_(world), a_(a), b_(b), path_a_(path_a), path_b_(path_b) {
    from_a_.resize(path_a.dof());
    to_a_.resize(path_a.dof());
    from_b_.resize(path_b.dof());
    to_b_.resize(path_b.dof());
  }

  // As earliest_contact(). Any contact will do where `is_first` is false.
  std::optional<double> run(double from, double until, bool is_first) {
    std::size_t i = path_a_.segment_at(from), j = path_b_.segment_at(from);
    double t = from;
    path_a_.at(t, from_a_);
    path_b_.at(t, from_b_);
    while (true) {
      const double end = std::min({next_time(path_a_, i), next_time(path_b_, j), until});
      if (std::isinf(end)) {
        return world_.are_clear(a_, from_a_, b_, from_b_) ? std::nullopt : std::optional(t);
      }
      path_a_.at(end, to_a_);
      path_b_.at(end, to_b_);
      if (end > t) {
        if (const auto contact = is_first ? first_contact(t, end) : any_contact(t)) return contact;
      }
      if (end >= until) return std::nullopt;
      t = end;
      from_a_.swap(to_a_);
      from_b_.swap(to_b_);
      follow(path_a_, i, t);
      follow(path_b_, j, t);
    }
  }

 private:
  std::optional<double> first_contact(double t, double end) const {
    return world_.first_contact(a_, {from_a_, to_a_, t, end}, b_, {from_b_, to_b_, t, end});
  }
  std::optional<double> any_contact(double t) const {
    if (world_.motions_are_clear(a_, from_a_, to_a_, b_, from_b_, to_b_)) return std::nullopt;
    return t;
  }

  const CollisionWorld& world_;
  RobotId a_, b_;
  const Trajectory& path_a_;
  const Trajectory& path_b_;
  Configuration from_a_, to_a_, from_b_, to_b_;
};

std::optional<double> contact(const CollisionWorld& world, RobotId a, const Trajectory& path_a,
                              RobotId b, const Trajectory& path_b, double from, double until,
                              bool is_first) {
  const auto radius_a = world.radius(a), radius_b = world.radius(b);
  if (radius_a && radius_b) {
    const double distance = *radius_a + *radius_b + world.required_separation();
    DistanceTally tally(world);
    return earliest_point_contact(path_a, path_b, distance, from, until, tally);
  }
  return Sweep(world, a, path_a, b, path_b).run(from, until, is_first);
}

}  // namespace

std::optional<double> earliest_contact(const CollisionWorld& world, RobotId a,
                                       const Trajectory& path_a, RobotId b,
                                       const Trajectory& path_b, double from, double until) {
  return contact(world, a, path_a, b, path_b, from, until, true);
}

bool paths_are_clear(const CollisionWorld& world, RobotId a, const Trajectory& path_a, RobotId b,
                     const Trajectory& path_b, double from, double until) {
  return !contact(world, a, path_a, b, path_b, from, until, false);
}

}  // namespace accord
