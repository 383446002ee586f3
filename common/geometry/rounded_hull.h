// A few vertices and a radius that hold many points: the hull of the vertices, rounded by the
// radius, contains them all. What meshes are as long as nothing is near.
#pragma once

#include <span>
#include <vector>

#include "common/geometry/frame.h"

namespace accord {

struct RoundedHull {
  std::vector<Vec<3>> vertices;
  double radius = 0;  // m

  // The farthest vertex along d.
  const Vec<3>& farthest(const Vec<3>& d) const;
};

// Chooses vertices from the points, so many (at most kMostHullVertices) that the radius becomes
// small against the points' extent: a few thousandths for most shapes.
// Requires: at least one point.
RoundedHull rounded_hull(std::span<const Vec<3>> points);

inline constexpr std::size_t kMostHullVertices = 64;

}  // namespace accord
