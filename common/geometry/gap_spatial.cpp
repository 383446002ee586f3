// Distances between spatial cores: closed forms for points and segments, gjk.h for boxes and
// cylinders, box hierarchies for meshes.
#include <algorithm>
#include <cmath>

#include "common/geometry/closed_forms.h"
#include "common/geometry/core_support.h"
#include "common/geometry/gap.h"
#include "common/geometry/gjk.h"
#include "common/geometry/mesh_surface.h"

namespace accord {
namespace {

using V = Vec<3>;
using Result = Gap<3>;

constexpr double kTouching = 1e-13;  // m, below it a vector is all rounding

Result between(const V& offset) {
  const double distance = offset.norm();
  if (distance <= kTouching) return {};
  return {distance, offset / distance, true};
}

Result reversed(Result gap) {
  gap.normal = -gap.normal;
  return gap;
}

// The separation along a guess at the normal: what holds even where the guess is off.
Result certified(const Placed<3>& a, const Placed<3>& b, const V& offset) {
  const double length = offset.norm();
  if (length <= kTouching) return {};
  const V n = offset / length;
  const double distance = separation_along(a, b, n);
  if (distance <= 0) return {};
  return {distance, n, true};
}

Result point_to(const V& point, const Placed<3>& other) {
  const V local = point - other.frame.t;
  const V half = other.piece->half;
  switch (other.piece->core) {
    case Core::kSegment:
      return between(to_segment<3>(local, other.frame.axis(), half.x()));
    case Core::kBox:
      return between(other.frame.rotate(to_box<3>(other.frame.unrotate(local), half)));
    case Core::kCylinder: {
      const V axis = other.frame.axis();
      const double along = local.dot(axis);
      const V across = local - along * axis;
      const double out = across.norm();
      V move = (std::clamp(along, -half.x(), half.x()) - along) * axis;
      if (out > half.y()) move -= (1 - half.y() / out) * across;
      return between(move);
    }
    default:
      return between(-local);
  }
}

Result segments(const Placed<3>& a, const Placed<3>& b) {
  const V offset = b.frame.t - a.frame.t;
  const V u = a.frame.axis();
  const V v = b.frame.axis();
  const SegmentParameters at =
      closest_on_segments<3>(u, a.piece->half.x(), offset, v, b.piece->half.x());
  return certified(a, b, offset + at.b * v - at.a * u);
}

Result segment_to_box(const Placed<3>& segment, const Placed<3>& box) {
  const V center = box.frame.inverse(segment.frame.t);
  const V axis = box.frame.unrotate(segment.frame.axis());
  const double t = closest_to_box<3>(center, axis, segment.piece->half.x(), box.piece->half);
  return between(box.frame.rotate(to_box<3>(center + t * axis, box.piece->half)));
}

// What gjk starts from: the caller's memory, or how the axes of long pieces lie to each other.
V first_direction(const Placed<3>& a, const Placed<3>& b, const V& hint) {
  if (!hint.isZero(0)) return hint;
  const V offset = b.frame.t - a.frame.t;
  const bool long_a = a.piece->core == Core::kSegment || a.piece->core == Core::kCylinder;
  const bool long_b = b.piece->core == Core::kSegment || b.piece->core == Core::kCylinder;
  V direction = offset;
  if (long_a && long_b) {
    const V u = a.frame.axis();
    const V v = b.frame.axis();
    const SegmentParameters at =
        closest_on_segments<3>(u, a.piece->half.x(), offset, v, b.piece->half.x());
    direction = offset + at.b * v - at.a * u;
  }
  return direction.squaredNorm() > kTouching * kTouching ? direction : V(V::UnitX());
}

Result convex(const Placed<3>& a, const Placed<3>& b, const Wanted& wanted, const V& hint) {
  const V first = first_direction(a, b, hint);
  return with_support(a, a.frame.t, [&](const auto& of_a) {
    return with_support(b, a.frame.t,
                        [&](const auto& of_b) { return gjk(of_a, of_b, wanted, first); });
  });
}

double hull_radius(const Placed<3>& placed) {
  return placed.piece->core == Core::kMesh ? placed.piece->mesh->hull().radius : 0.0;
}

// First by the hulls, whose normal is worth having; then triangle by triangle.
Result meshes(const Placed<3>& a, const Placed<3>& b, const Wanted& wanted, const V& hint) {
  const double radii = hull_radius(a) + hull_radius(b);
  Wanted coarse = wanted;
  coarse.enough += radii;
  coarse.contact += radii;
  coarse.tolerance = std::max(wanted.tolerance, 0.1 * radii);
  Result result = convex(a, b, coarse, hint);
  result.distance = std::max(result.distance - radii, 0.0);
  if (result.distance >= wanted.enough) return result;
  // Near the hull it would not do: a motion into a hollow would stop short of it.
  const double far = 0.02 * (a.piece->bound + b.piece->bound) + 4 * radii;
  if (wanted.hull_will_do && result.distance > wanted.contact + far) return result;
  double distance;
  if (a.piece->core != Core::kMesh) {
    distance = b.piece->mesh->distance(b.frame, a, wanted);
  } else if (b.piece->core != Core::kMesh) {
    distance = a.piece->mesh->distance(a.frame, b, wanted);
  } else {
    distance = a.piece->mesh->distance(a.frame, *b.piece->mesh, b.frame, wanted);
  }
  result.distance = std::max(result.distance, distance);
  return result;
}

Result to_half_space(const Placed<3>& a, const Placed<3>& wall, const Wanted& wanted) {
  const V n = wall.frame.axis();
  const double by_hull = separation_along(a, wall, n);
  if (a.piece->core == Core::kMesh && by_hull < wanted.enough) {
    const double reach = a.piece->mesh->support(a.frame.unrotate(n));
    return {n.dot(wall.frame.t - a.frame.t) - reach, n, true};
  }
  return {by_hull, n, true};
}

}  // namespace

template <>
Gap<3> gap(const Placed<3>& a, const Placed<3>& b, const Wanted& wanted, const V& hint) {
  const Core ca = a.piece->core;
  const Core cb = b.piece->core;
  if (cb == Core::kHalfSpace) return to_half_space(a, b, wanted);
  if (ca == Core::kMesh || cb == Core::kMesh) return meshes(a, b, wanted, hint);
  if (ca == Core::kPoint) return point_to(a.frame.t, b);
  if (cb == Core::kPoint) return reversed(point_to(b.frame.t, a));
  if (ca == Core::kSegment && cb == Core::kSegment) return segments(a, b);
  if (ca == Core::kSegment && cb == Core::kBox) return segment_to_box(a, b);
  if (cb == Core::kSegment && ca == Core::kBox) return reversed(segment_to_box(b, a));
  return convex(a, b, wanted, hint);
}

}  // namespace accord
