// Distances that have closed forms, in coordinates where the second shape is at rest. Exact but for
// the rounding of a few operations. Units: metres. Pure functions.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/frame.h"

namespace accord {

// What a point p must be moved by to lie in the box of half extents `half` about the origin.
template <int D>
Vec<D> to_box(const Vec<D>& p, const Vec<D>& half) {
  return p.cwiseMin(half).cwiseMax(-half) - p;
}

// What a point p must be moved by to lie on the segment from -half to half along `axis` (unit).
template <int D>
Vec<D> to_segment(const Vec<D>& p, const Vec<D>& axis, double half) {
  return std::clamp(p.dot(axis), -half, half) * axis - p;
}

// The closest points of two segments: parameters along each.
struct SegmentParameters {
  double a;
  double b;
};

// Segments |s| <= half_a of the line s * axis_a, and |t| <= half_b of offset + t * axis_b (unit
// axes). Below an angle of 1e-7 the lines' common perpendicular is lost to rounding, and the best
// end stands for it: callers that need a certificate evaluate the direction between the points.
template <int D>
SegmentParameters closest_on_segments(const Vec<D>& axis_a, double half_a, const Vec<D>& offset,
                                      const Vec<D>& axis_b, double half_b) {
  const double cosine = axis_a.dot(axis_b);
  const double along_a = axis_a.dot(offset);
  const double along_b = axis_b.dot(offset);
  const Vec<D> across = axis_a - cosine * axis_b;  // as a vector: 1 - cosine^2 would cancel
  const double sine2 = across.squaredNorm();
  if (sine2 > 1e-14) {
    const double s = offset.dot(across) / sine2;
    if (std::abs(s) <= half_a) {
      const double t = s * cosine - along_b;
      if (std::abs(t) <= half_b) return {s, t};
    }
  }
  // Otherwise the minimum is at an end of one of them.
  SegmentParameters best{0, 0};
  double best_squared = std::numeric_limits<double>::infinity();
  const auto consider = [&](double s, double t) {
    const double squared = (offset + t * axis_b - s * axis_a).squaredNorm();
    if (squared < best_squared) {
      best_squared = squared;
      best = {s, t};
    }
  };
  for (const double t : {-half_b, half_b}) {
    consider(std::clamp(along_a + t * cosine, -half_a, half_a), t);
  }
  for (const double s : {-half_a, half_a}) {
    consider(s, std::clamp(s * cosine - along_b, -half_b, half_b));
  }
  return best;
}

// The parameter t, |t| <= reach, at which c + t * axis is closest to the box of half extents `half`
// about the origin. The squared distance is convex and piecewise quadratic in t, so its derivative
// is piecewise linear and rising: its zero lies between two of the at most 2 D breakpoints.
template <int D>
double closest_to_box(const Vec<D>& c, const Vec<D>& axis, double reach, const Vec<D>& half) {
  const auto slope = [&](double t) { return -to_box<D>(c + t * axis, half).dot(axis); };
  double low = -reach;
  double high = reach;
  double slope_low = slope(low);
  if (slope_low >= 0) return low;
  double slope_high = slope(high);
  if (slope_high <= 0) return high;
  for (int i = 0; i < D; ++i) {
    if (axis[i] == 0) continue;
    for (const double side : {-half[i], half[i]}) {
      const double t = (side - c[i]) / axis[i];
      if (!(t > low && t < high)) continue;
      const double value = slope(t);
      if (value == 0) return t;
      if (value < 0) {
        low = t;
        slope_low = value;
      } else {
        high = t;
        slope_high = value;
      }
    }
  }
  return low + (high - low) * (slope_low / (slope_low - slope_high));
}

}  // namespace accord
