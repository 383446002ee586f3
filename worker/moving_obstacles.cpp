#include "worker/moving_obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/point_motion.h"

namespace accord {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Intervals shorter than this are of no use and only cost time.
constexpr double kShortestInterval = 1e-6;  // s
constexpr double kSlack = MovingObstacles::kSlack;

// The k for which |offset + k step|^2 <= squared. nullopt: none.
std::optional<Interval> span_within(const Vec3& offset, const Vec3& step, double squared) {
  const double a = step.squaredNorm(), b = offset.dot(step), c = offset.squaredNorm() - squared;
  if (a == 0) {
    if (c > 0) return std::nullopt;
    return Interval{-kInfinity, kInfinity};
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const double root = std::sqrt(discriminant);
  return Interval{(-b - root) / a, (-b + root) / a};
}

// The complement of `unsafe` from `from` on. Sorts its input.
void complement(std::vector<Interval>& unsafe, double from, std::vector<Interval>& out) {
  out.clear();
  std::ranges::sort(unsafe, {}, &Interval::lo);
  double safe_from = from;
  for (const Interval& interval : unsafe) {
    const double safe_until = interval.lo - kSlack;
    if (safe_until > safe_from + kShortestInterval) out.push_back({safe_from, safe_until});
    safe_from = std::max(safe_from, interval.hi + kSlack);
  }
  if (safe_from < kInfinity) out.push_back({safe_from, kInfinity});
}

}  // namespace

MovingObstacles::MovingObstacles(const CollisionWorld& world, RobotId robot, double from)
    : world_(world),
      robot_(robot),
      from_(from),
      own_distance_(world.radius(robot).value_or(0) + world.required_separation()),
      tally_(world) {}

void MovingObstacles::add(RobotId other, const Trajectory& path, double until) {
  const auto mine = world_.radius(robot_), theirs = world_.radius(other);
  if (mine && theirs) {
    add_points(path, *theirs, until);
    return;
  }
  bodies_.push_back(std::make_shared<MovingBody>(world_, robot_, other, path, from_, until));
}

void MovingObstacles::add_points(const Trajectory& path, double radius, double until) {
  for (std::size_t i = path.segment_at(from_); i < path.size(); ++i) {
    if (path.time(i) >= until) continue;
    const bool last = i + 1 == path.size();
    PointTraffic::Piece piece{path.time(i), until, to_point(path.configuration(i)), Vec3::Zero(),
                              radius};
    if (!last) {
      piece.velocity =
          (to_point(path.configuration(i + 1)) - piece.position) / (path.time(i + 1) - piece.t0);
      piece.t1 = std::min(until, path.time(i + 1));
    }
    points_.push_back(piece);
    const Vec3 end = std::isinf(piece.t1)
                         ? piece.position
                         : Vec3(piece.position + (piece.t1 - piece.t0) * piece.velocity);
    const Vec3 room = Vec3::Constant(distance_to(piece));
    reaches_.push_back({piece.position.cwiseMin(end) - room, piece.position.cwiseMax(end) + room});
  }
}

void MovingObstacles::safe_intervals(ConfigurationView q, double since,
                                     const std::optional<MovingBody::Name>& name,
                                     std::vector<Interval>& out) {
  since = std::max(since, from_);
  unsafe_.clear();
  point_unsafe(points_near(q, q, since, kInfinity), q, unsafe_);
  if (!bodies_.empty()) {
    const Aabb here = world_.swept_bounds(robot_, q, q);
    for (const auto& body : bodies_) body->add_unsafe(q, here, since, name, unsafe_);
  }
  complement(unsafe_, since, out);
}

std::uint64_t MovingObstacles::checks() const {
  std::uint64_t sum = 0;
  for (const auto& body : bodies_) sum += body->checks();
  return sum;
}

void MovingObstacles::add(const PointTraffic& traffic, const std::vector<char>* only) {
  traffic_.emplace_back(&traffic, only);
}

const MovingObstacles::Points& MovingObstacles::points_near(ConfigurationView a,
                                                            ConfigurationView b, double since,
                                                            double until) {
  near_.clear();
  if (!points_.empty()) {
    const Vec3 from = to_point(a), to = to_point(b);
    const Aabb swept{from.cwiseMin(to), from.cwiseMax(to)};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (points_[i].t1 <= since || points_[i].t0 >= until) continue;
      if (reaches_[i].overlaps(swept)) near_.push_back(&points_[i]);
    }
  }
  for (const auto& [traffic, only] : traffic_) {
    traffic->near(to_point(a), to_point(b), since, until, only, near_);
  }
  return near_;
}

// |p + v s - q| < d for s in the roots of a quadratic.
void MovingObstacles::point_unsafe(const Points& points, ConfigurationView q,
                                   std::vector<Interval>& unsafe) const {
  if (points.empty()) return;
  tally_.add(points.size());
  const Vec3 here = to_point(q);
  for (const PointTraffic::Piece* piece : points) {
    const Vec3 offset = piece->position - here;
    const double distance = distance_to(*piece);
    const double c = offset.squaredNorm() - distance * distance;
    const double a = piece->velocity.squaredNorm();
    if (a == 0) {
      if (c < 0) unsafe.push_back({piece->t0, piece->t1});
      continue;
    }
    const double b = offset.dot(piece->velocity);
    const double discriminant = b * b - a * c;
    if (discriminant <= 0) continue;
    const double root = std::sqrt(discriminant);
    const double lo = std::max(piece->t0, piece->t0 + (-b - root) / a);
    const double hi = std::min(piece->t1, piece->t0 + (-b + root) / a);
    if (lo < hi) unsafe.push_back({lo, hi});
  }
}

// The earliest departure from t on that is clear of the first piece that departing at t runs into;
// t itself when that is clear of all points.
double MovingObstacles::point_next_departure(const Points& points, const Vec3& a,
                                             const Vec3& velocity, double duration,
                                             double t) const {
  for (const PointTraffic::Piece* piece : points) {
    const double lo = std::max(t, piece->t0);
    const double hi = std::min(t + duration, piece->t1);
    if (lo >= hi) continue;
    const Vec3 offset =
        piece->position + (lo - piece->t0) * piece->velocity - a - (lo - t) * velocity;
    const Vec3 step = (hi - lo) * (piece->velocity - velocity);
    tally_.add(1);
    if (!first_within(offset, step, distance_to(*piece))) continue;
    // Whoever is parked in the way now will be so whenever the motion starts.
    if (std::isinf(piece->t1)) return kInfinity;
    return std::max(t, last_unsafe_departure(*piece, a, velocity, duration)) + kSlack;
  }
  return t;
}

// The robot that departs at s is at a + u velocity at s + u. Where it touches the piece is a convex
// set of (s, u), cut out of |offset + s w + u c| <= distance (w: the piece's velocity, c: the
// relative one) by 0 <= u <= duration and t0 <= s + u <= t1. Its largest s lies on one of the four
// edges or where the line of constant s is a tangent.
double MovingObstacles::last_unsafe_departure(const PointTraffic::Piece& piece, const Vec3& a,
                                              const Vec3& velocity, double duration) const {
  const double squared = distance_to(piece) * distance_to(piece);
  const Vec3 offset = piece.position - a;  // at s = u = 0, times counted from t0
  const Vec3& w = piece.velocity;
  const Vec3 c = w - velocity;
  const double length = piece.t1 - piece.t0;
  double last = -kInfinity;
  // On an edge, (s, u) = (s0 + s1 k, u0 + u1 k) for k in [lo, hi].
  const auto along_edge = [&](double s0, double s1, double u0, double u1, double lo, double hi) {
    if (lo > hi) return;
    const auto span = span_within(offset + s0 * w + u0 * c, s1 * w + u1 * c, squared);
    if (!span) return;
    const double first_k = std::max(lo, span->lo), last_k = std::min(hi, span->hi);
    if (first_k <= last_k) last = std::max({last, s0 + s1 * first_k, s0 + s1 * last_k});
  };
  along_edge(0, 1, 0, 0, 0, length);                            // u = 0
  along_edge(0, 1, duration, 0, -duration, length - duration);  // u = duration
  along_edge(0, -1, 0, 1, 0, duration);                         // s + u = t0
  along_edge(length, -1, 0, 1, 0, duration);                    // s + u = t1
  const double speed = c.squaredNorm();
  if (speed > 0) {
    const Vec3 across = offset - (offset.dot(c) / speed) * c;
    const auto span = span_within(across, w - (w.dot(c) / speed) * c, squared);
    if (span && std::isfinite(span->hi)) {
      const double s = span->hi, u = -(offset + s * w).dot(c) / speed;
      if (u >= 0 && u <= duration && s + u >= 0 && s + u <= length) last = std::max(last, s);
    }
  }
  return piece.t0 + last;
}

MovingBody::Passage MovingObstacles::past_bodies(ConfigurationView a, ConfigurationView b, double t,
                                                 double duration) {
  if (bodies_.empty()) return MovingBody::Passage::kClear;
  const Aabb bounds = world_.swept_bounds(robot_, a, b);
  for (const auto& body : bodies_) {
    const MovingBody::Passage passage = body->passage(a, b, bounds, t, duration);
    if (passage != MovingBody::Passage::kClear) return passage;
  }
  return MovingBody::Passage::kClear;
}

bool MovingObstacles::motion_is_clear(ConfigurationView a, ConfigurationView b, double t,
                                      double duration) {
  const Points& points = points_near(a, b, t, t + duration);
  if (!points.empty()) {
    const Vec3 from = to_point(a);
    const Vec3 velocity = (to_point(b) - from) / duration;
    if (point_next_departure(points, from, velocity, duration, t) > t) return false;
  }
  return past_bodies(a, b, t, duration) == MovingBody::Passage::kClear;
}

std::optional<double> MovingObstacles::earliest_departure(ConfigurationView a, ConfigurationView b,
                                                          double duration, double lo, double hi) {
  double t = lo;
  double step = world_.scene().timestep;
  const Points& points = points_near(a, b, lo, hi + duration);
  const bool any = !points.empty();
  const Vec3 from = any ? to_point(a) : Vec3(Vec3::Zero());
  const Vec3 velocity = any ? Vec3((to_point(b) - from) / duration) : Vec3(Vec3::Zero());
  while (t <= hi) {
    if (any) {
      const double next = point_next_departure(points, from, velocity, duration, t);
      if (std::isinf(next)) break;
      if (next > t) {
        t = next;
        continue;
      }
    }
    const MovingBody::Passage passage = past_bodies(a, b, t, duration);
    if (passage == MovingBody::Passage::kClear) return t;
    if (passage == MovingBody::Passage::kBlockedForGood || t == hi) break;
    t = std::min(t + step, hi);
    step *= 1.5;
  }
  return std::nullopt;
}

}  // namespace accord
