// Closed forms for points on linear motions: what discs and balls reduce to.
#pragma once

#include <cmath>
#include <optional>

#include "common/model/shape.h"

namespace accord {

// The least u in [0, 1] at which |offset + u * drift| < distance; nullopt if there is none.
// offset is the vector between two points at u = 0, drift its change until u = 1.
// The quadratic is solved in the form that does not cancel. Already closer at u = 0 gives 0.
inline std::optional<double> first_within(const Vec3& offset, const Vec3& drift, double distance) {
  const double c = offset.squaredNorm() - distance * distance;
  if (c < 0) return 0.0;
  const double b = offset.dot(drift);
  if (b >= 0) return std::nullopt;  // not approaching
  const double a = drift.squaredNorm();
  const double discriminant = b * b - a * c;
  if (discriminant <= 0) return std::nullopt;
  const double u = c / (-b + std::sqrt(discriminant));
  if (u >= 1) return std::nullopt;
  return u;
}

}  // namespace accord
