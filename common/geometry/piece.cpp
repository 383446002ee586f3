#include "common/geometry/piece.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/mesh_surface.h"

namespace accord {

template <>
double support(const Placed<2>& placed, const Vec<2>& m) {
  const Piece<2>& piece = *placed.piece;
  switch (piece.core) {
    case Core::kSegment:
      return piece.half.x() * std::abs(placed.frame.axis().dot(m));
    case Core::kBox: {
      const Vec<2> local = placed.frame.unrotate(m);
      return piece.half.x() * std::abs(local.x()) + piece.half.y() * std::abs(local.y());
    }
    case Core::kPolygon: {
      const Vec<2> local = placed.frame.unrotate(m);
      double best = local.dot(piece.vertices[0]);
      for (int i = 1; i < piece.vertex_count; ++i) {
        best = std::max(best, local.dot(piece.vertices[static_cast<std::size_t>(i)]));
      }
      return best;
    }
    default:  // points; half spaces along their normal
      return 0;
  }
}

template <>
double support(const Placed<3>& placed, const Vec<3>& m) {
  const Piece<3>& piece = *placed.piece;
  switch (piece.core) {
    case Core::kSegment:
      return piece.half.x() * std::abs(placed.frame.axis().dot(m));
    case Core::kMesh: {  // a mesh lies within its rounded hull
      const Vec<3> local = placed.frame.unrotate(m);
      const RoundedHull& hull = piece.mesh->hull();
      return local.dot(hull.farthest(local)) + hull.radius * m.norm();
    }
    case Core::kBox: {
      const Vec<3> local = placed.frame.unrotate(m);
      return piece.half.dot(local.cwiseAbs());
    }
    case Core::kCylinder: {
      const Vec<3> axis = placed.frame.axis();
      const double along = axis.dot(m);
      // As a vector: |m|^2 - along^2 would lose half of the digits where m is nearly the axis.
      const Vec<3> across = m - along * axis;
      return piece.half.x() * std::abs(along) + piece.half.y() * across.norm();
    }
    default:
      return 0;
  }
}

template <int D>
Vec<D> half_extents(const Placed<D>& placed) {
  Vec<D> half;
  for (int i = 0; i < D; ++i) {
    const Vec<D> m = Vec<D>::Unit(i);
    half[i] = std::max(support(placed, m), support(placed, Vec<D>(-m)));
  }
  return half;
}

template Vec<2> half_extents(const Placed<2>&);
template Vec<3> half_extents(const Placed<3>&);

}  // namespace accord
