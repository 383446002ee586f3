// Support points of cores, as gjk.h wants them, one class a core, so that its loops are compiled
// for each pair. Points are relative to an origin near by: coordinates stay small.
#pragma once

#include <array>
#include <cmath>

#include "common/geometry/mesh_surface.h"
#include "common/geometry/piece.h"

namespace accord {

class PointSupport {
 public:
  explicit PointSupport(const Vec<3>& t) : t_(t) {}
  Vec<3> operator()(const Vec<3>&) const { return t_; }

 private:
  Vec<3> t_;
};

class SegmentSupport {
 public:
  SegmentSupport(const Vec<3>& t, const Vec<3>& reach) : t_(t), reach_(reach) {}
  Vec<3> operator()(const Vec<3>& d) const {
    return reach_.dot(d) >= 0 ? Vec<3>(t_ + reach_) : Vec<3>(t_ - reach_);
  }

 private:
  Vec<3> t_;
  Vec<3> reach_;
};

class BoxSupport {
 public:
  BoxSupport(const Vec<3>& t, const Eigen::Matrix3d& r, const Vec<3>& half)
      : t_(t), edges_(r * half.asDiagonal()) {}
  Vec<3> operator()(const Vec<3>& d) const {
    Vec<3> p = t_;
    for (int i = 0; i < 3; ++i) {
      const Vec<3> edge = edges_.col(i);
      p += std::copysign(1.0, edge.dot(d)) * edge;
    }
    return p;
  }

 private:
  Vec<3> t_;
  Eigen::Matrix3d edges_;  // half edges, as columns
};

class CylinderSupport {
 public:
  CylinderSupport(const Vec<3>& t, const Vec<3>& axis, double half, double radius)
      : t_(t), axis_(axis), half_(half), radius_(radius) {}
  Vec<3> operator()(const Vec<3>& d) const {
    const double along = axis_.dot(d);
    Vec<3> end = t_ + std::copysign(half_, along) * axis_;
    Vec<3> across = d - along * axis_;
    double squared = across.squaredNorm();
    if (squared <= 1e-8 * along * along) {  // what is left may be all rounding: once more
      across -= axis_.dot(across) * axis_;
      squared = across.squaredNorm();
      // Along the axis the whole end is farthest; its centre serves every way.
      if (squared <= 1e-28 * along * along) return end;
    }
    return end + (radius_ / std::sqrt(squared)) * across;
  }

 private:
  Vec<3> t_;
  Vec<3> axis_;
  double half_;
  double radius_;
};

// A mesh stands for its hull here, without the radius.
class HullSupport {
 public:
  HullSupport(const Vec<3>& t, const Eigen::Matrix3d& r, const RoundedHull& hull)
      : t_(t), r_(r), hull_(hull) {}
  Vec<3> operator()(const Vec<3>& d) const { return t_ + r_ * hull_.farthest(r_.transpose() * d); }

 private:
  Vec<3> t_;
  const Eigen::Matrix3d& r_;
  const RoundedHull& hull_;
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

// Calls what(support) with the support of a core, relative to `origin`.
template <typename What>
auto with_support(const Placed<3>& placed, const Vec<3>& origin, What&& what) {
  const Vec<3> t = placed.frame.t - origin;
  const Vec<3>& half = placed.piece->half;
  switch (placed.piece->core) {
    case Core::kSegment:
      return what(SegmentSupport(t, half.x() * placed.frame.axis()));
    case Core::kBox:
      return what(BoxSupport(t, placed.frame.r, half));
    case Core::kCylinder:
      return what(CylinderSupport(t, placed.frame.axis(), half.x(), half.y()));
    case Core::kMesh:
      return what(HullSupport(t, placed.frame.r, placed.piece->mesh->hull()));
    default:
      return what(PointSupport(t));
  }
}

}  // namespace accord
