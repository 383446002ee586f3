// Distances between planar cores: closed forms all of them. Two separated convex polygons are
// closest at a vertex of one of them.
#include <algorithm>
#include <array>
#include <cmath>

#include "common/geometry/closed_forms.h"
#include "common/geometry/gap.h"

namespace accord {
namespace {

using V = Vec<2>;
using Result = Gap<2>;

double cross(const V& a, const V& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// From the vector between closest points. Below `kTouching` it is all rounding.
constexpr double kTouching = 1e-13;

Result between(const V& offset) {
  const double distance = offset.norm();
  if (distance <= kTouching) return {};
  return {distance, offset / distance, true};
}

// Vertices of a core, in the coordinates of a frame.
struct Corners {
  std::array<V, kMaxVertices> at;
  std::size_t count = 0;
};

// Relative to `origin`: coordinates stay small far from the world's origin.
Corners corners_of(const Placed<2>& placed, const V& origin) {
  const Piece<2>& piece = *placed.piece;
  const V t = placed.frame.t - origin;
  Corners corners;
  switch (piece.core) {
    case Core::kSegment: {
      const V reach = piece.half.x() * placed.frame.axis();
      corners.at[0] = t - reach;
      corners.at[1] = t + reach;
      corners.count = 2;
      break;
    }
    case Core::kBox: {
      const V u = piece.half.x() * placed.frame.axis();
      const V v = piece.half.y() * V(-placed.frame.s, placed.frame.c);
      corners.at[0] = t - u - v;
      corners.at[1] = t + u - v;
      corners.at[2] = t + u + v;
      corners.at[3] = t - u + v;
      corners.count = 4;
      break;
    }
    case Core::kPolygon:
      corners.count = static_cast<std::size_t>(piece.vertex_count);
      for (std::size_t i = 0; i < corners.count; ++i) {
        corners.at[i] = t + placed.frame.rotate(piece.vertices[i]);
      }
      break;
    default:
      corners.at[0] = t;
      corners.count = 1;
  }
  return corners;
}

// The best separation of q from p along p's outward edge normals: of the lines through p's edges,
// the one that q is farthest beyond. (A segment has two edges, there and back.)
struct Separation {
  double distance;
  V normal;
};

Separation beyond_edges(const Corners& p, const Corners& q) {
  Separation best{-1e300, V::UnitX()};
  for (std::size_t i = 0; i < p.count; ++i) {
    const V& a = p.at[i];
    const V edge = p.at[i + 1 < p.count ? i + 1 : 0] - a;
    const V normal = V(edge.y(), -edge.x()).normalized();
    double nearest = normal.dot(q.at[0] - a);
    for (std::size_t j = 1; j < q.count; ++j) {
      nearest = std::min(nearest, normal.dot(q.at[j] - a));
    }
    if (nearest > best.distance) best = {nearest, normal};
  }
  return best;
}

// The shortest vector from p's edges to q's vertices.
void nearest_corner(const Corners& p, const Corners& q, double sign, double& best, V& offset) {
  const std::size_t edges = p.count == 2 ? 1 : p.count;
  for (std::size_t i = 0; i < edges; ++i) {
    const V& a = p.at[i];
    const V edge = p.at[i + 1 < p.count ? i + 1 : 0] - a;
    const double squared = edge.squaredNorm();
    for (std::size_t j = 0; j < q.count; ++j) {
      const V d = q.at[j] - a;
      const double u = squared > 0 ? std::clamp(d.dot(edge) / squared, 0.0, 1.0) : 0.0;
      const V between = d - u * edge;
      const double value = between.squaredNorm();
      if (value < best) {
        best = value;
        offset = sign * between;
      }
    }
  }
}

Result polygons(const Placed<2>& a, const Placed<2>& b, double enough) {
  const Corners p = corners_of(a, a.frame.t);
  const Corners q = corners_of(b, a.frame.t);
  Separation separation{-1e300, V::UnitX()};
  if (p.count > 1) separation = beyond_edges(p, q);
  if (q.count > 1) {
    const Separation other = beyond_edges(q, p);
    if (other.distance > separation.distance) separation = {other.distance, -other.normal};
  }
  if (separation.distance >= enough) return {separation.distance, separation.normal, true};
  // Two segments on one line are apart though no edge's normal says so.
  const bool flat = p.count <= 2 && q.count <= 2;
  if (separation.distance <= 0 && !flat) return {};
  if (flat && separation.distance <= 0 && p.count == 2 && q.count == 2) {
    const V ea = p.at[1] - p.at[0];
    const V eb = q.at[1] - q.at[0];
    const double a0 = cross(ea, q.at[0] - p.at[0]);
    const double a1 = cross(ea, q.at[1] - p.at[0]);
    const double b0 = cross(eb, p.at[0] - q.at[0]);
    const double b1 = cross(eb, p.at[1] - q.at[0]);
    if (a0 * a1 < 0 && b0 * b1 < 0) return {};  // they cross
  }
  double best = 1e300;
  V offset = V::Zero();
  if (p.count > 1) nearest_corner(p, q, 1.0, best, offset);
  if (q.count > 1) nearest_corner(q, p, -1.0, best, offset);
  Result result = between(offset);
  if (separation.distance >= result.distance * (1 - 1e-9)) result.normal = separation.normal;
  return result;
}

// The vertices of a rectangle (centre t, half axes u and v) nearest to the box about the origin.
void nearest_to_box(const V& half, const V& t, const V& u, const V& v, double& best, V& offset) {
  for (const V& corner : {V(t - u - v), V(t + u - v), V(t + u + v), V(t - u + v)}) {
    const V move = to_box<2>(corner, half);
    const double value = move.squaredNorm();
    if (value < best) {
      best = value;
      offset = move;
    }
  }
}

// Separating axis test on the four axes, then the eight vertices.
Result boxes(const Placed<2>& a, const Placed<2>& b, double enough) {
  const V& ha = a.piece->half;
  const V& hb = b.piece->half;
  const V offset = b.frame.t - a.frame.t;
  const V ta = a.frame.unrotate(offset);  // b's centre seen from a
  const V tb = b.frame.unrotate(offset);  // minus a's centre seen from b
  const double c = a.frame.c * b.frame.c + a.frame.s * b.frame.s;
  const double s = a.frame.c * b.frame.s - a.frame.s * b.frame.c;
  const double ac = std::abs(c);
  const double as = std::abs(s);
  const double ax = std::abs(ta.x()) - (ha.x() + hb.x() * ac + hb.y() * as);
  const double ay = std::abs(ta.y()) - (ha.y() + hb.x() * as + hb.y() * ac);
  const double bx = std::abs(tb.x()) - (hb.x() + ha.x() * ac + ha.y() * as);
  const double by = std::abs(tb.y()) - (hb.y() + ha.x() * as + ha.y() * ac);
  const double along = std::max(std::max(ax, ay), std::max(bx, by));
  if (along <= 0) return {};
  V axis;
  if (along == ax) {
    axis = std::copysign(1.0, ta.x()) * V(a.frame.c, a.frame.s);
  } else if (along == ay) {
    axis = std::copysign(1.0, ta.y()) * V(-a.frame.s, a.frame.c);
  } else if (along == bx) {
    axis = std::copysign(1.0, tb.x()) * V(b.frame.c, b.frame.s);
  } else {
    axis = std::copysign(1.0, tb.y()) * V(-b.frame.s, b.frame.c);
  }
  if (along >= enough) return {along, axis, true};
  double best = 1e300;
  V move = V::Zero();
  nearest_to_box(ha, ta, hb.x() * V(c, s), hb.y() * V(-s, c), best, move);
  V normal = a.frame.rotate(-move);
  const double best_on_a = best;
  nearest_to_box(hb, -tb, ha.x() * V(c, -s), ha.y() * V(s, c), best, move);
  if (best < best_on_a) normal = b.frame.rotate(move);
  const double distance = std::sqrt(best);
  // Where an edge faces a vertex the axis says it better; near contact it is all there is.
  if (along >= distance * (1 - 1e-9)) return {distance, axis, true};
  return {distance, normal / distance, true};
}

Result point_to_box(const V& point, const Placed<2>& box) {
  const V move = to_box<2>(box.frame.inverse(point), box.piece->half);
  return between(box.frame.rotate(move));
}

Result point_to_segment(const V& point, const Placed<2>& segment) {
  return between(
      to_segment<2>(point - segment.frame.t, segment.frame.axis(), segment.piece->half.x()));
}

Result to_half_space(const Placed<2>& a, const Placed<2>& wall) {
  const V n = wall.frame.axis();
  return {separation_along(a, wall, n), n, true};
}

Result reversed(Result gap) {
  gap.normal = -gap.normal;
  return gap;
}

}  // namespace

template <>
Gap<2> gap(const Placed<2>& a, const Placed<2>& b, const Wanted& wanted, const V& /*hint*/) {
  const Core ca = a.piece->core;
  const Core cb = b.piece->core;
  if (cb == Core::kHalfSpace) return to_half_space(a, b);
  if (ca == Core::kPoint) {
    if (cb == Core::kPoint) return between(b.frame.t - a.frame.t);
    if (cb == Core::kSegment) return point_to_segment(a.frame.t, b);
    if (cb == Core::kBox) return point_to_box(a.frame.t, b);
  } else if (cb == Core::kPoint) {
    if (ca == Core::kSegment) return reversed(point_to_segment(b.frame.t, a));
    if (ca == Core::kBox) return reversed(point_to_box(b.frame.t, a));
  } else if (ca == Core::kBox && cb == Core::kBox) {
    return boxes(a, b, wanted.enough);
  }
  return polygons(a, b, wanted.enough);
}

}  // namespace accord
