// A quick opinion on two bodies: each lies within a capsule and holds a smaller one, and segments
// have a closed form where boxes and cylinders need an iteration.
#pragma once

#include "common/geometry/piece.h"

namespace accord {

enum class Opinion { kNone, kApart, kTouching };

// kApart: the cores are at least `need` apart. kTouching: at most `keep`. `between` becomes the
// vector between the outer capsules' segments, a good guess at the cores' normal, where it was
// computed. Planar cores have closed forms throughout: no opinion.
inline Opinion by_capsules(const Placed<2>&, const Placed<2>&, double, double, Vec<2>&) {
  return Opinion::kNone;
}
Opinion by_capsules(const Placed<3>& a, const Placed<3>& b, double keep, double need,
                    Vec<3>& between);

// The capsules of a core with the given half extents: along its longest edge, or a cylinder's axis.
CoreCapsules box_capsules(const Vec<3>& half, bool solid);
CoreCapsules cylinder_capsules(double half, double radius);
CoreCapsules segment_capsules(double half);

}  // namespace accord
