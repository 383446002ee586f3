// The boxes that a ball on a straight way can touch: a filter for BoxTree that is as good along
// the diagonal as along the axes.
#pragma once

#include <array>
#include <cmath>

#include "common/geometry/extent.h"

namespace accord {

template <int D>
class Sweep {
 public:
  // All points within `radius` of the segment from `from` to `to`.
  Sweep(const Vec<D>& from, const Vec<D>& to, double radius)
      : extent_(Extent<D>{from.cwiseMin(to), from.cwiseMax(to)}.inflated(radius)),
        middle_((from + to) / 2) {
    const Vec<D> way = to - from;
    if constexpr (D == 2) {
      normals_[0] = {-way.y(), way.x()};
    } else {
      for (int i = 0; i < 3; ++i) {
        normals_[static_cast<std::size_t>(i)] = way.cross(Vec<3>(Vec<3>::Unit(i)));
      }
    }
    for (std::size_t i = 0; i < kNormals; ++i) reach_[i] = radius * normals_[i].norm();
  }

  const Extent<D>& extent() const { return extent_; }

  // False only where the box is out of reach: separating axes across the way.
  bool operator()(const Extent<D>& box) const {
    if (!extent_.overlaps(box)) return false;
    const Vec<D> offset = (box.min + box.max) / 2 - middle_;
    const Vec<D> half = (box.max - box.min) / 2;
    for (std::size_t i = 0; i < kNormals; ++i) {
      const Vec<D>& n = normals_[i];
      const double apart = std::abs(n.dot(offset)) - half.dot(n.cwiseAbs());
      if (apart > reach_[i] * (1 + 1e-9)) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t kNormals = D == 2 ? 1 : 3;
  Extent<D> extent_;
  Vec<D> middle_;
  std::array<Vec<D>, kNormals> normals_;
  std::array<double, kNormals> reach_{};
};

}  // namespace accord
