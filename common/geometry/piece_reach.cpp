#include "common/geometry/piece_reach.h"

#include <algorithm>
#include <cmath>

namespace accord {

PieceReach reach_of(const Piece<2>& piece) {
  const Frame<2>& f = piece.frame;
  double reach = f.t.norm();
  const auto corner = [&](const Vec<2>& p) { reach = std::max(reach, f(p).norm()); };
  if (piece.core == Core::kPolygon) {
    for (int i = 0; i < piece.vertex_count; ++i) {
      corner(piece.vertices[static_cast<std::size_t>(i)]);
    }
  } else {
    for (const double x : {-piece.half.x(), piece.half.x()}) {
      for (const double y : {-piece.half.y(), piece.half.y()}) corner({x, y});
    }
  }
  return {reach, reach};
}

PieceReach reach_of(const Piece<3>& piece) {
  const Frame<3>& f = piece.frame;
  double reach = f.t.norm();
  double across = f.t.head<2>().norm();
  const auto corner = [&](const Vec<3>& p) {
    reach = std::max(reach, f(p).norm());
    across = std::max(across, f(p).head<2>().norm());
  };
  switch (piece.core) {
    case Core::kSegment:
      for (const double z : {-piece.half.x(), piece.half.x()}) corner({0, 0, z});
      break;
    case Core::kCylinder: {
      const double radius = piece.half.y();
      const Vec<3> axis = f.axis();
      for (const double z : {-piece.half.x(), piece.half.x()}) {
        const Vec<3> end = f({0, 0, z});
        const double along = end.dot(axis);
        const double out = (end - along * axis).norm() + radius;
        reach = std::max(reach, std::sqrt(along * along + out * out));
        across = std::max(across, end.head<2>().norm() + radius);
      }
      break;
    }
    default:
      for (int i = 0; i < 8; ++i) {
        corner({(i & 1) != 0 ? piece.half.x() : -piece.half.x(),
                (i & 2) != 0 ? piece.half.y() : -piece.half.y(),
                (i & 4) != 0 ? piece.half.z() : -piece.half.z()});
      }
  }
  return {reach, across};
}

}  // namespace accord
