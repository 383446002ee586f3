// Where two pieces come closest and by how much they overlap: for messages to people, so estimates
// will do. Certificates are gap.h's business.
#pragma once

#include "common/geometry/piece.h"

namespace accord {

// The core's point closest to p. Meshes stand for their boxes.
template <int D>
Vec<D> project(const Placed<D>& placed, const Vec<D>& p);

// A point between the two pieces where they are closest, or inside of both.
template <int D>
Vec<D> meeting_point(const Placed<D>& a, const Placed<D>& b);

// m: how far one of two overlapping pieces would have to move to come free, radii included. Exact
// for convex planar pieces, an upper estimate for spatial ones; positive.
template <int D>
double overlap(const Placed<D>& a, const Placed<D>& b);

}  // namespace accord
