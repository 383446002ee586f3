#include "common/geometry/mesh_surface.h"

#include <fcl/geometry/bvh/BVH_model.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/geometry/core_support.h"
#include "common/geometry/gjk.h"

namespace accord {
namespace {

using Hierarchy = fcl::BVHModel<fcl::AABBd>;
using Node = fcl::BVNode<fcl::AABBd>;
using Bv = fcl::AABBd;

double distance_squared(const Bv& a, const Bv& b) {
  return (b.min_ - a.max_).cwiseMax(a.min_ - b.max_).cwiseMax(0.0).squaredNorm();
}

// The box of a box that is seen from another frame.
Bv moved(const Bv& box, const Frame<3>& frame) {
  const Vec3 center = frame((box.min_ + box.max_) / 2);
  const Vec3 half = frame.r.cwiseAbs() * ((box.max_ - box.min_) / 2);
  return {Vec3(center - half), Vec3(center + half)};
}

Frame<3> seen_from(const Frame<3>& base, const Frame<3>& frame) {
  return {base.r.transpose() * frame.r, base.inverse(frame.t)};
}

}  // namespace

struct MeshSurface::Tree {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Hierarchy hierarchy;

  const Node& node(int i) const { return hierarchy.getBV(i); }
  TriangleSupport triangle(int i) const {
    const auto& t = triangles[static_cast<std::size_t>(i)];
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  }
  TriangleSupport triangle(int i, const Frame<3>& frame) const {
    const auto& t = triangles[static_cast<std::size_t>(i)];
    return {frame(vertices[t[0]]), frame(vertices[t[1]]), frame(vertices[t[2]])};
  }
  Vec3 middle(int i) const {
    const auto& t = triangles[static_cast<std::size_t>(i)];
    return (vertices[t[0]] + vertices[t[1]] + vertices[t[2]]) / 3;
  }

  // The least distance found so far; what cannot be nearer is passed over.
  struct Search {
    Wanted wanted;  // wanted.enough: the least so far
    // Where it lay: neighbouring triangles are mostly settled by the direction of the last.
    Vec3 normal = Vec3::Zero();
    bool done() const { return wanted.enough <= wanted.contact; }
    bool passes(double squared) const { return squared >= wanted.enough * wanted.enough; }
    Vec3 hint(const Vec3& offset) const {
      if (!normal.isZero(0)) return normal;
      return offset.isZero(0) ? Vec3(Vec3::UnitX()) : offset;
    }
    void take(const Gap<3>& gap) {
      if (gap.separates) normal = gap.normal;
      wanted.enough = std::min(wanted.enough, gap.distance);
    }
  };

  void search(int i, const Placed<3>& core, const Bv& core_box, Search& search) const;
  void search(int i, const Tree& other, int j, const Frame<3>& other_frame, Search& search) const;
};

MeshSurface::MeshSurface(const TriangleMesh& mesh)
    : closed_(mesh.closed), tree_(std::make_unique<Tree>()) {
  Vec3 low = mesh.vertices[mesh.triangles.front()[0]];
  Vec3 high = low;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      low = low.cwiseMin(mesh.vertices[v]);
      high = high.cwiseMax(mesh.vertices[v]);
    }
  }
  center_ = (low + high) / 2;
  tree_->triangles = mesh.triangles;
  for (const Vec3& v : mesh.vertices) tree_->vertices.push_back(v - center_);
  half_.setZero();
  std::vector<Vec3> used;
  std::vector<fcl::Triangle> triangles;
  for (const auto& triangle : mesh.triangles) {
    triangles.emplace_back(triangle[0], triangle[1], triangle[2]);
    for (const std::uint32_t v : triangle) {
      half_ = half_.cwiseMax(tree_->vertices[v].cwiseAbs());
      bound_ = std::max(bound_, tree_->vertices[v].norm());
      used.push_back(tree_->vertices[v]);
    }
  }
  std::sort(used.begin(), used.end(), [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  used.erase(std::unique(used.begin(), used.end()), used.end());
  hull_ = rounded_hull(used);
  tree_->hierarchy.beginModel(static_cast<int>(triangles.size()),
                              static_cast<int>(tree_->vertices.size()));
  tree_->hierarchy.addSubModel(tree_->vertices, triangles);
  tree_->hierarchy.endModel();
}

MeshSurface::~MeshSurface() = default;

void MeshSurface::Tree::search(int i, const Placed<3>& core, const Bv& core_box,
                               Search& search) const {
  const Node& n = node(i);
  if (n.isLeaf()) {
    const int primitive = n.primitiveId();
    const Vec3 hint = search.hint(core.frame.t - middle(primitive));
    search.take(with_support(core, Vec3::Zero(), [&](const auto& support) {
      return gjk(triangle(primitive), support, search.wanted, hint);
    }));
    return;
  }
  const int left = n.leftChild();
  const int right = n.rightChild();
  double near = distance_squared(node(left).bv, core_box);
  double far = distance_squared(node(right).bv, core_box);
  int first = left;
  int second = right;
  if (far < near) {
    std::swap(near, far);
    std::swap(first, second);
  }
  if (!search.done() && !search.passes(near)) this->search(first, core, core_box, search);
  if (!search.done() && !search.passes(far)) this->search(second, core, core_box, search);
}

void MeshSurface::Tree::search(int i, const Tree& other, int j, const Frame<3>& other_frame,
                               Search& search) const {
  const Node& a = node(i);
  const Node& b = other.node(j);
  if (a.isLeaf() && b.isLeaf()) {
    const int p = a.primitiveId();
    const int q = b.primitiveId();
    search.take(gjk(triangle(p), other.triangle(q, other_frame), search.wanted,
                    search.hint(other_frame(other.middle(q)) - middle(p))));
    return;
  }
  // Split the larger one.
  const bool split_a = b.isLeaf() || (!a.isLeaf() && a.bv.size() >= b.bv.size());
  std::array<std::array<int, 2>, 2> next;
  std::array<double, 2> squared;
  for (std::size_t k = 0; k < 2; ++k) {
    const int child = split_a ? (k == 0 ? a.leftChild() : a.rightChild())
                              : (k == 0 ? b.leftChild() : b.rightChild());
    next[k] = split_a ? std::array<int, 2>{child, j} : std::array<int, 2>{i, child};
    squared[k] =
        distance_squared(node(next[k][0]).bv, moved(other.node(next[k][1]).bv, other_frame));
  }
  const std::size_t near = squared[1] < squared[0] ? 1 : 0;
  for (const std::size_t k : {near, 1 - near}) {
    if (search.done() || search.passes(squared[k])) continue;
    this->search(next[k][0], other, next[k][1], other_frame, search);
  }
}

Vec3 MeshSurface::some_point() const {
  return tree_->vertices[tree_->triangles.front()[0]];
}

double MeshSurface::distance(const Frame<3>& frame, const Placed<3>& core,
                             const Wanted& wanted) const {
  const Placed<3> local{core.piece, seen_from(frame, core.frame)};
  const Vec3 half = accord::half_extents(local);
  Tree::Search search{wanted};
  tree_->search(0, local, Bv(local.frame.t - half, local.frame.t + half), search);
  return search.wanted.enough;
}

double MeshSurface::distance(const Frame<3>& frame, const MeshSurface& other,
                             const Frame<3>& other_frame, const Wanted& wanted) const {
  Tree::Search search{wanted};
  tree_->search(0, *other.tree_, 0, seen_from(frame, other_frame), search);
  return search.wanted.enough;
}

bool MeshSurface::contains(const Vec3& point) const {
  if (!closed_ || (point.cwiseAbs() - half_).maxCoeff() > 0) return false;
  // A direction that no modelled edge is likely to meet exactly.
  const Vec3 direction(0.80191751, 0.26754123, 0.53413709);
  bool inside = false;
  for (const auto& t : tree_->triangles) {  // Moeller and Trumbore 1997
    const Vec3& a = tree_->vertices[t[0]];
    const Vec3 ab = tree_->vertices[t[1]] - a;
    const Vec3 ac = tree_->vertices[t[2]] - a;
    const Vec3 p = direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0) continue;
    const Vec3 from = point - a;
    const double u = from.dot(p) / determinant;
    if (u < 0 || u > 1) continue;
    const Vec3 q = from.cross(ab);
    const double v = direction.dot(q) / determinant;
    if (v < 0 || u + v > 1) continue;
    if (ac.dot(q) / determinant > 0) inside = !inside;
  }
  return inside;
}

double MeshSurface::support(const Vec3& m) const {
  double best = -1e300;
  for (const auto& t : tree_->triangles) {
    for (const std::uint32_t v : t) best = std::max(best, m.dot(tree_->vertices[v]));
  }
  return best;
}

}  // namespace accord
