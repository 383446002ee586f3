// The distance between the cores of two convex pieces, with the direction that proves it.
#pragma once

#include <limits>

#include "common/geometry/piece.h"

namespace accord {

template <int D>
struct Gap {
  // m: a lower bound on the distance between the cores, 0 where they overlap or touch (against
  // half spaces it goes on below 0). Radii are not taken off.
  double distance = 0;
  // Unit, from the first to the second. Where `separates`, the cores lie at least `distance` apart
  // along it (but for rounding).
  Vec<D> normal = Vec<D>::Unit(0);
  bool separates = false;
};

// How much of a distance is wanted. Iterative methods stop once the bound is at least `enough`, or
// the distance is known to be at most `contact`, or bound and distance are no farther apart than
// `tolerance`, or than `relative` times what the bound exceeds `contact` by.
struct Wanted {
  double enough = std::numeric_limits<double>::infinity();  // m
  double contact = 0;                                       // m
  double tolerance = 1e-10;                                 // m
  double relative = 0;
  bool hull_will_do = false;  // a mesh may stand for its hull, where that is clear of `contact`
};

// `hint` is a guess at the normal, any length but 0; good ones save time, none changes what holds.
// At most one of the two is a half space; it must be the second.
template <int D>
Gap<D> gap(const Placed<D>& a, const Placed<D>& b, const Wanted& wanted, const Vec<D>& hint);

// The separation of the cores along the unit vector n, from a to b: a lower bound on their distance
// for any n.
template <int D>
double separation_along(const Placed<D>& a, const Placed<D>& b, const Vec<D>& n) {
  return n.dot(b.frame.t - a.frame.t) - support(a, n) - support(b, Vec<D>(-n));
}

}  // namespace accord
