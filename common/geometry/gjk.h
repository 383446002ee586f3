// The distance between two convex sets, each given by its support points: Gilbert, Johnson and
// Keerthi 1988, with the duality gap as the measure of convergence. What it returns is not the
// length of the last vector but the best separation found along any direction on the way,
// evaluated by support points: a lower bound that holds however far the iteration came.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "common/geometry/gap.h"

namespace accord {

// Up to four points of the Minkowski difference b - a, affinely independent in exact arithmetic.
struct GjkSimplex {
  std::array<Vec<3>, 4> points;
  int count = 0;

  bool contains(const Vec<3>& p) const {
    for (int i = 0; i < count; ++i) {
      if (points[static_cast<std::size_t>(i)] == p) return true;
    }
    return false;
  }
};

// Writes the simplex's point closest to the origin to `closest` and keeps only the vertices that
// it needs. False where the origin is inside.
bool reduce_to_closest(GjkSimplex& simplex, Vec<3>& closest);

// A and B: callable with a direction (any length but 0), returning the set's point farthest along
// it; both in the same coordinates, whose origin should be near.
// `least`, where given, is lowered to the distance of the closest two points that were met: an
// upper bound.
template <typename A, typename B>
Gap<3> gjk(const A& a, const B& b, const Wanted& wanted, const Vec<3>& hint,
           double* least = nullptr) {
  constexpr int kMostIterations = 60;
  constexpr double kTouching = 1e-13;  // m
  Gap<3> best;
  GjkSimplex simplex;
  Vec<3> v = hint;
  double upper = 1e300;  // on the distance
  for (int i = 0; i < kMostIterations; ++i) {
    const double length = v.norm();
    if (!(length > kTouching)) break;
    const Vec<3> n = v / length;
    const Vec<3> w = b(Vec<3>(-n)) - a(n);
    const double lower = n.dot(w);
    if (lower > best.distance) best = {lower, n, true};
    if (best.distance >= wanted.enough) break;
    const double doubt = upper - best.distance;
    if (doubt <= wanted.tolerance) break;
    if (doubt <= wanted.relative * (best.distance - wanted.contact)) break;
    if (simplex.contains(w)) break;
    simplex.points[static_cast<std::size_t>(simplex.count++)] = w;
    if (!reduce_to_closest(simplex, v)) v.setZero();
    const double next = v.norm();
    if (least != nullptr) *least = std::min(*least, next);
    if (next <= wanted.contact) break;
    if (!(next < upper)) break;  // no progress but rounding
    upper = next;
  }
  return best;
}

}  // namespace accord
