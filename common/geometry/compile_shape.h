// Turns the scene's shapes into convex pieces. Called while a CollisionWorld is built.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "common/geometry/piece.h"
#include "common/model/shape.h"

namespace accord {

// Surfaces that were compiled already: robots of one model share them.
using MeshCache = std::map<const TriangleMesh*, std::shared_ptr<const MeshSurface>>;

// The pieces of a shape at `pose`; their frames are in the coordinates that pose maps to (a link's,
// or the world's). D = 2: of its cut with z = 0 there.
// Throws std::invalid_argument where the dimension has no such shape (planar_cut.h says why).
template <int D>
std::vector<Piece<D>> compile_shape(const Shape& shape, const Pose& pose, MeshCache& meshes);

}  // namespace accord
