#include "common/geometry/gjk.h"

#include <limits>

namespace accord {
namespace {

using V = Vec<3>;

// The part of a simplex that carries the point closest to the origin.
struct Feature {
  std::array<V, 3> points;
  int count;
  V closest;
  double squared;
};

Feature vertex(const V& a) {
  return {{a, a, a}, 1, a, a.squaredNorm()};
}

Feature segment(const V& a, const V& b) {
  const V ab = b - a;
  const double t = -a.dot(ab);
  if (t <= 0) return vertex(a);
  const double length = ab.squaredNorm();
  if (t >= length) return vertex(b);
  const V closest = a + (t / length) * ab;
  return {{a, b, b}, 2, closest, closest.squaredNorm()};
}

const Feature& nearer(const Feature& p, const Feature& q) {
  return q.squared < p.squared ? q : p;
}

// By the regions of Ericson, Real-Time Collision Detection, 5.1.5; where the origin projects into
// the triangle, its distance comes from the plane, which cancels less than the corners.
Feature triangle(const V& a, const V& b, const V& c) {
  const V ab = b - a;
  const V ac = c - a;
  const V normal = ab.cross(ac);
  const double area = normal.squaredNorm();
  // Which sides of the edges the origin's projection is on.
  const double side_ab = normal.dot(a.cross(b));
  const double side_bc = normal.dot(b.cross(c));
  const double side_ca = normal.dot(c.cross(a));
  if (area > 0 && side_ab >= 0 && side_bc >= 0 && side_ca >= 0) {
    const V closest = (normal.dot(a) / area) * normal;
    return {{a, b, c}, 3, closest, closest.squaredNorm()};
  }
  // Outside of at least one edge, and closest to one that it is outside of.
  Feature best{{a, a, a}, 1, a, std::numeric_limits<double>::infinity()};
  const bool all = !(area > 0);
  if (all || side_ab < 0) best = nearer(best, segment(a, b));
  if (all || side_bc < 0) best = nearer(best, segment(b, c));
  if (all || side_ca < 0) best = nearer(best, segment(c, a));
  return best;
}

// Whether the origin is beyond the plane of a, b, c as seen from d; also true where the four points
// are so flat that rounding decides.
bool beyond(const V& a, const V& b, const V& c, const V& d) {
  const V normal = (b - a).cross(c - a);
  const double inner = normal.dot(d - a);
  const double origin = -normal.dot(a);
  const double noise = 1e-14 * normal.norm() * (d - a).norm();
  if (std::abs(inner) <= noise) return true;
  return inner > 0 ? origin < 0 : origin > 0;
}

}  // namespace

bool reduce_to_closest(GjkSimplex& simplex, V& closest) {
  const auto& p = simplex.points;
  Feature best = vertex(p[0]);
  switch (simplex.count) {
    case 1:
      break;
    case 2:
      best = segment(p[0], p[1]);
      break;
    case 3:
      best = triangle(p[0], p[1], p[2]);
      break;
    default: {
      best.squared = std::numeric_limits<double>::infinity();
      bool outside = false;
      for (const auto& f :
           {std::array<std::size_t, 4>{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}) {
        if (!beyond(p[f[0]], p[f[1]], p[f[2]], p[f[3]])) continue;
        outside = true;
        best = nearer(best, triangle(p[f[0]], p[f[1]], p[f[2]]));
      }
      if (!outside) return false;
    }
  }
  simplex.count = best.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(best.count); ++i) {
    simplex.points[i] = best.points[i];
  }
  closest = best.closest;
  return true;
}

}  // namespace accord
