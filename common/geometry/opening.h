// Conservative advancement to second order, along one direction: pieces that part, pass, or meet
// slowly are proved apart for far longer than a bound on speed alone would have it.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/geometry/piece.h"

namespace accord {

// The separation of two pieces along a fixed direction, as the way goes on by s: a concave function
// less what the pieces' paths can bend.
template <int D>
struct Opening {
  const Placed<D>& a;
  const Placed<D>& b;
  Vec<D> normal;
  Vec<D> turn_a;
  Vec<D> turn_b;
  double apart;    // between the frames' origins, along the normal
  double closing;  // its rate
  double keep;

  // Without the bend. The support of a core that turns is that of the core at rest in a direction
  // that turns the other way: n . (p + s w x p) = (n + s n x w) . p.
  double operator()(double s) const {
    return apart + s * closing - support(a, Vec<D>(normal + s * turn_a)) -
           support(b, Vec<D>(-normal - s * turn_b)) - keep;
  }
};

// An x in [0, wanted] such that opening(side * t) - bend t^2 / 2 >= 0 for all t in [0, x]. The
// opening is concave, so that it lies above its chords, and the root of a chord with the bend
// taken off is safe; shorter chords are closer to it.
template <int D>
double safe_way(const Opening<D>& opening, double at_zero, double bend, double side,
                double wanted) {
  double safe = 0;
  double end = wanted;
  for (int i = 0; i < 3; ++i) {
    const double at_end = opening(side * end);
    if (at_end - 0.5 * bend * end * end >= 0) return std::max(safe, end);
    const double slope = (at_end - at_zero) / end;
    const double root = std::sqrt(slope * slope + 2 * bend * at_zero);
    const double x = slope > 0 ? (slope + root) / bend : 2 * at_zero / (root - slope);
    safe = std::max(safe, x * (1 - 1e-12));
    if (1.2 * safe >= 0.9 * end) break;  // a shorter chord would tell little more
    end = 1.2 * safe;
  }
  return std::min(safe, wanted);
}

}  // namespace accord
