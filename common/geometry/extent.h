// Boxes along the axes of the world. Units: metres.
#pragma once

#include <algorithm>
#include <limits>

#include "common/geometry/frame.h"

namespace accord {

template <int D>
struct Extent {
  Vec<D> min;
  Vec<D> max;

  // Holds nothing; merging makes it grow.
  static Extent nothing() {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    return {Vec<D>::Constant(kFar), Vec<D>::Constant(-kFar)};
  }

  bool overlaps(const Extent& other) const {
    for (int i = 0; i < D; ++i) {
      if (min[i] > other.max[i] || other.min[i] > max[i]) return false;
    }
    return true;
  }
  void merge(const Extent& other) {
    min = min.cwiseMin(other.min);
    max = max.cwiseMax(other.max);
  }
  Extent inflated(double by) const { return {min.array() - by, max.array() + by}; }
  double squared_distance(const Extent& other) const {
    double sum = 0;
    for (int i = 0; i < D; ++i) {
      const double d = std::max(std::max(min[i] - other.max[i], other.min[i] - max[i]), 0.0);
      sum += d * d;
    }
    return sum;
  }
};

}  // namespace accord
