#include "common/geometry/capsules.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/closed_forms.h"

namespace accord {

Opinion by_capsules(const Placed<3>& a, const Placed<3>& b, double keep, double need,
                    Vec<3>& between) {
  const CoreCapsules& p = a.piece->capsules;
  const CoreCapsules& q = b.piece->capsules;
  if (p.outer_radius < 0 || q.outer_radius < 0) return Opinion::kNone;
  if (p.outer_radius == 0 && q.outer_radius == 0) return Opinion::kNone;  // segments: no news
  const Vec<3> offset = b.frame.t - a.frame.t;
  const Vec<3> u = a.frame.r.col(p.axis);
  const Vec<3> v = b.frame.r.col(q.axis);
  const auto shortest = [&](double half_a, double half_b) -> Vec<3> {
    const SegmentParameters at = closest_on_segments<3>(u, half_a, offset, v, half_b);
    return offset + at.b * v - at.a * u;
  };
  between = shortest(p.outer_half, q.outer_half);
  // By the separation along the line between: that holds whatever became of the parameters.
  const double length = between.norm();
  const double apart = between.dot(offset) - p.outer_half * std::abs(between.dot(u)) -
                       q.outer_half * std::abs(between.dot(v));
  if (length > 0 && apart >= (need + p.outer_radius + q.outer_radius) * length) {
    return Opinion::kApart;
  }
  if (p.inner_radius < 0 || q.inner_radius < 0) return Opinion::kNone;
  const double touching = keep + p.inner_radius + q.inner_radius;
  // The outer segments hold the inner ones.
  if (touching <= 0 || length > touching) return Opinion::kNone;
  const bool inside = shortest(p.inner_half, q.inner_half).squaredNorm() <= touching * touching;
  return inside ? Opinion::kTouching : Opinion::kNone;
}

CoreCapsules box_capsules(const Vec<3>& half, bool solid) {
  CoreCapsules capsules;
  capsules.outer_half = half.maxCoeff(&capsules.axis);
  Vec<3> rest = half;
  rest[capsules.axis] = 0;
  capsules.outer_radius = rest.norm();
  if (!solid) return capsules;
  rest[capsules.axis] = capsules.outer_half;
  capsules.inner_radius = rest.minCoeff();
  capsules.inner_half = capsules.outer_half - capsules.inner_radius;
  return capsules;
}

CoreCapsules cylinder_capsules(double half, double radius) {
  CoreCapsules capsules;
  capsules.outer_half = half;
  capsules.outer_radius = radius;
  capsules.inner_radius = std::min(half, radius);
  capsules.inner_half = half - capsules.inner_radius;
  return capsules;
}

CoreCapsules segment_capsules(double half) {
  CoreCapsules capsules;
  capsules.outer_half = capsules.inner_half = half;
  capsules.outer_radius = capsules.inner_radius = 0;
  return capsules;
}

}  // namespace accord
