#include "common/geometry/rounded_hull.h"

#include <algorithm>
#include <limits>

#include "common/geometry/gjk.h"

namespace accord {
namespace {

// An upper bound on the point's distance from the vertices' hull, tight but for rounding.
double distance_from(const RoundedHull& hull, const Vec<3>& point) {
  const auto vertices = [&](const Vec<3>& d) -> Vec<3> { return hull.farthest(d) - point; };
  const auto origin = [](const Vec<3>&) -> Vec<3> { return Vec<3>::Zero(); };
  const Vec<3> hint = point - hull.vertices.front();
  if (hint.isZero(0)) return 0;
  double upper = hint.norm();
  gjk(vertices, origin, Wanted{}, hint, &upper);
  return upper;
}

}  // namespace

const Vec<3>& RoundedHull::farthest(const Vec<3>& d) const {
  std::size_t best = 0;
  double most = vertices[0].dot(d);
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const double value = vertices[i].dot(d);
    if (value > most) {
      most = value;
      best = i;
    }
  }
  return vertices[best];
}

// Takes in points that lie outside by more than a tolerance, which falls from round to round, so
// that the corners that matter most come first.
RoundedHull rounded_hull(std::span<const Vec<3>> points) {
  Vec<3> low = points[0];
  Vec<3> high = points[0];
  for (const Vec<3>& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).norm();
  constexpr double kFirst = 0.2;  // of the extent
  constexpr double kLast = 0.001;
  RoundedHull hull;
  hull.vertices.push_back(points[0]);
  for (double tolerance = kFirst; tolerance >= kLast; tolerance /= 2) {
    for (const Vec<3>& p : points) {
      if (hull.vertices.size() >= kMostHullVertices) break;
      if (distance_from(hull, p) > tolerance * extent) hull.vertices.push_back(p);
    }
  }
  for (const Vec<3>& p : points) hull.radius = std::max(hull.radius, distance_from(hull, p));
  hull.radius = hull.radius * (1 + 1e-9) + 1e-14 * extent;
  return hull;
}

}  // namespace accord
