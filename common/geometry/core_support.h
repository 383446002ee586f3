// Support points of cores, as gjk.h wants them.
#pragma once

#include <array>
#include <cmath>

#include "common/geometry/mesh_surface.h"
#include "common/geometry/piece.h"

namespace accord {

// Points relative to `origin`, which keeps coordinates small far from the world's origin.
class CoreSupport {
 public:
  CoreSupport(const Placed<3>& placed, const Vec<3>& origin)
      : piece_(*placed.piece), frame_(placed.frame), t_(placed.frame.t - origin) {}

  Vec<3> operator()(const Vec<3>& d) const {
    switch (piece_.core) {
      case Core::kSegment:
        return t_ + std::copysign(piece_.half.x(), frame_.axis().dot(d)) * frame_.axis();
      case Core::kMesh:  // stands for its hull here, without the radius
        return t_ + frame_.rotate(piece_.mesh->hull().farthest(frame_.unrotate(d)));
      case Core::kBox: {
        const Vec<3> local = frame_.unrotate(d);
        return t_ + frame_.rotate({std::copysign(piece_.half.x(), local.x()),
                                   std::copysign(piece_.half.y(), local.y()),
                                   std::copysign(piece_.half.z(), local.z())});
      }
      case Core::kCylinder: {
        const Vec<3> axis = frame_.axis();
        const double along = axis.dot(d);
        const Vec<3> end = t_ + std::copysign(piece_.half.x(), along) * axis;
        Vec<3> across = d - along * axis;
        across -= axis.dot(across) * axis;  // again: what is left may be all rounding
        const double length = across.norm();
        // Along the axis the whole end is farthest; its centre serves every way.
        if (length <= 1e-14 * std::abs(along)) return end;
        return end + (piece_.half.y() / length) * across;
      }
      default:
        return t_;
    }
  }

 private:
  const Piece<3>& piece_;
  const Frame<3>& frame_;
  Vec<3> t_;
};

class TriangleSupport {
 public:
  TriangleSupport(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) : corners_{a, b, c} {}

  Vec<3> operator()(const Vec<3>& d) const {
    const double a = corners_[0].dot(d);
    const double b = corners_[1].dot(d);
    const double c = corners_[2].dot(d);
    if (a >= b) return a >= c ? corners_[0] : corners_[2];
    return b >= c ? corners_[1] : corners_[2];
  }

 private:
  std::array<Vec<3>, 3> corners_;
};

}  // namespace accord
