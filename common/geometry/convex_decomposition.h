// Splits a simple polygon into convex ones: ear clipping, then merging across diagonals that are
// not needed (Hertel and Mehlhorn 1983), which gives at most four times the least number.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/model/shape.h"

namespace accord {

// Counter-clockwise convex polygons of 3 to `most` vertices whose union is the polygon. Vertices
// that repeat or lie on the line between their neighbours are dropped; nothing is left of a polygon
// without area.
// Requires: a simple polygon, counter-clockwise; most >= 3. Time about n^2 log n, n^3 at worst.
std::vector<std::vector<Vec2>> convex_decomposition(std::span<const Vec2> polygon,
                                                    std::size_t most);

}  // namespace accord
