// A triangle surface with a hierarchy of boxes (FCL's BVHModel), for distances that are lower
// bounds whatever happens: boxes are compared exactly, triangles by gjk.h. FCL's own mesh distance
// is not used, since it overestimates (platform.md), which no certificate survives. Immutable;
// const members may be called concurrently.
#pragma once

#include <memory>

#include "common/geometry/gap.h"
#include "common/geometry/rounded_hull.h"
#include "common/model/shape.h"

namespace accord {

class MeshSurface {
 public:
  // Requires: at least one triangle. Keeps its own copy, centred on its box.
  explicit MeshSurface(const TriangleMesh& mesh);
  ~MeshSurface();
  MeshSurface(const MeshSurface&) = delete;
  MeshSurface& operator=(const MeshSurface&) = delete;

  const Vec3& center() const { return center_; }      // of its box, in the mesh's coordinates
  const Vec3& half_extents() const { return half_; }  // of its box
  double bound() const { return bound_; }             // of its vertices' distance from the centre
  bool closed() const { return closed_; }
  const RoundedHull& hull() const { return hull_; }  // of the surface, about the centre

  Vec3 some_point() const;  // a vertex, about the centre

  // A lower bound on the distance between the surface (placed so that its centre is at frame.t) and
  // a convex core; at most wanted.enough.
  double distance(const Frame<3>& frame, const Placed<3>& core, const Wanted& wanted) const;

  // The same between two surfaces.
  double distance(const Frame<3>& frame, const MeshSurface& other, const Frame<3>& other_frame,
                  const Wanted& wanted) const;

  // Whether a closed surface has the point (in coordinates about its centre) inside; false for open
  // ones. By the parity of a ray's crossings.
  bool contains(const Vec3& point) const;

  // The greatest m . p over the surface's points p (about its centre). Looks at every vertex.
  double support(const Vec3& m) const;

 private:
  struct Tree;
  Vec3 center_;
  Vec3 half_;
  double bound_ = 0;
  RoundedHull hull_;
  bool closed_ = false;
  std::unique_ptr<Tree> tree_;
};

}  // namespace accord
