// What every shape is compiled to: convex pieces, each a core (point, segment, box, ...) and a
// radius by which it is rounded. Discs are points with a radius, capsules segments with one.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "common/geometry/frame.h"

namespace accord {

class MeshSurface;

enum class Core : unsigned char {
  kPoint,
  kSegment,    // along frame.axis(), half.x() to either side
  kBox,        // half: half extents
  kPolygon,    // planar: up to kMaxVertices vertices, convex, counter-clockwise
  kCylinder,   // spatial: along frame.axis(), half.x() to either side, half.y() its radius
  kMesh,       // spatial: a triangle surface; half: half extents of its box, which is centred
  kHalfSpace,  // all p with (p - frame.t) . frame.axis() >= 0; obstacles only
};

inline constexpr int kMaxVertices = 8;

// Two capsules about an axis of the frame, centred, one round the core and one within; by their
// segments' half lengths and radii. A radius below 0: there is none.
struct CoreCapsules {
  int axis = 2;
  double outer_half = 0;
  double outer_radius = -1;
  double inner_half = 0;
  double inner_radius = -1;
};

template <int D>
struct Piece {
  Core core = Core::kPoint;
  double radius = 0;             // m, rounds the core
  double bound = 0;              // m, the core lies within this distance of frame.t
  Vec<D> half = Vec<D>::Zero();  // see Core
  Frame<D> frame;                // in the link's frame; frame.t is the piece's centre
  std::array<Vec<2>, kMaxVertices> vertices{};  // kPolygon; in the piece's frame
  int vertex_count = 0;
  std::shared_ptr<const MeshSurface> mesh;  // kMesh; in the piece's frame
  CoreCapsules capsules;                    // spatial: of cores that are not points
};

// A piece where it is at an instant. Valid as long as the piece is.
template <int D>
struct Placed {
  const Piece<D>* piece = nullptr;
  Frame<D> frame;  // world
};

// The greatest m . (p - frame.t) over the core's points p. For a half space only where m is a
// multiple of its inward normal turned round.
template <int D>
double support(const Placed<D>& placed, const Vec<D>& m);

// Half extents, along the world's axes, of the core about frame.t.
template <int D>
Vec<D> half_extents(const Placed<D>& placed);

}  // namespace accord
