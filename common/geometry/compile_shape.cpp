#include "common/geometry/compile_shape.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "common/geometry/capsules.h"
#include "common/geometry/convex_decomposition.h"
#include "common/geometry/mesh_surface.h"
#include "common/geometry/planar_cut.h"

namespace accord {
namespace {

Frame<2> frame_along(const Vec2& center, const Vec2& axis) {
  return {axis.x(), axis.y(), center};
}

Piece<2> point(const Vec2& center, double radius) {
  Piece<2> piece;
  piece.radius = radius;
  piece.frame.t = center;
  return piece;
}

Piece<2> segment(const Vec2& a, const Vec2& b, double radius) {
  const double length = (b - a).norm();
  if (length <= 0) return point(a, radius);
  Piece<2> piece;
  piece.core = Core::kSegment;
  piece.radius = radius;
  piece.half.x() = length / 2;
  piece.bound = piece.half.x();
  piece.frame = frame_along((a + b) / 2, (b - a) / length);
  return piece;
}

// Whether four vertices form a rectangle but for rounding.
bool is_rectangle(const std::vector<Vec2>& v) {
  if (v.size() != 4) return false;
  const Vec2 u = v[1] - v[0];
  const Vec2 w = v[3] - v[0];
  const double size = u.norm() + w.norm();
  return (v[0] + v[2] - v[1] - v[3]).norm() <= 1e-14 * size &&
         std::abs(u.dot(w)) <= 1e-14 * size * size;
}

Piece<2> convex(const std::vector<Vec2>& v) {
  Piece<2> piece;
  if (is_rectangle(v)) {
    const double width = (v[1] - v[0]).norm();
    piece.core = Core::kBox;
    piece.frame = frame_along((v[0] + v[2]) / 2, (v[1] - v[0]) / width);
    piece.half = Vec2(width, (v[3] - v[0]).norm()) / 2;
    piece.bound = piece.half.norm();
    return piece;
  }
  piece.core = Core::kPolygon;
  Vec2 low = v[0];
  Vec2 high = v[0];
  for (const Vec2& p : v) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  piece.frame.t = (low + high) / 2;
  for (const Vec2& p : v) {
    piece.vertices[static_cast<std::size_t>(piece.vertex_count++)] = p - piece.frame.t;
    piece.bound = std::max(piece.bound, (p - piece.frame.t).norm());
  }
  return piece;
}

std::vector<Piece<2>> planar_pieces(const PlanarDisc& disc) {
  return {point(disc.center, disc.radius)};
}

std::vector<Piece<2>> planar_pieces(const PlanarCapsule& capsule) {
  return {segment(capsule.a, capsule.b, capsule.radius)};
}

std::vector<Piece<2>> planar_pieces(const PlanarPolygon& polygon) {
  std::vector<Piece<2>> pieces;
  for (const auto& part : convex_decomposition(polygon.vertices, kMaxVertices)) {
    pieces.push_back(convex(part));
  }
  if (pieces.empty()) throw std::invalid_argument("has no area");
  return pieces;
}

Piece<3> spatial_piece(const Sphere& sphere, const Pose& pose, MeshCache&) {
  Piece<3> piece;
  piece.radius = sphere.radius;
  piece.frame = frame_of(pose);
  return piece;
}

Piece<3> spatial_piece(const Capsule& capsule, const Pose& pose, MeshCache& meshes) {
  if (capsule.length <= 0) return spatial_piece(Sphere{capsule.radius}, pose, meshes);
  Piece<3> piece;
  piece.core = Core::kSegment;
  piece.radius = capsule.radius;
  piece.capsules = segment_capsules(capsule.length / 2);
  piece.half.x() = capsule.length / 2;
  piece.bound = piece.half.x();
  piece.frame = frame_of(pose);
  return piece;
}

Piece<3> spatial_piece(const Cylinder& cylinder, const Pose& pose, MeshCache&) {
  Piece<3> piece;
  piece.core = Core::kCylinder;
  piece.half = {cylinder.length / 2, cylinder.radius, 0};
  piece.capsules = cylinder_capsules(cylinder.length / 2, cylinder.radius);
  piece.bound = piece.half.norm();
  piece.frame = frame_of(pose);
  return piece;
}

Piece<3> spatial_piece(const Box& box, const Pose& pose, MeshCache&) {
  Piece<3> piece;
  piece.core = Core::kBox;
  piece.half = box.size / 2;
  piece.capsules = box_capsules(piece.half, true);
  piece.bound = piece.half.norm();
  piece.frame = frame_of(pose);
  return piece;
}

Piece<3> spatial_piece(const Polygon&, const Pose&, MeshCache&) {
  throw std::invalid_argument("is a polygon, which only planar scenes take");
}

Piece<3> spatial_piece(const Mesh& mesh, const Pose& pose, MeshCache& meshes) {
  if (mesh.surface->triangles.empty()) throw std::invalid_argument("is a mesh without triangles");
  Piece<3> piece;
  piece.core = Core::kMesh;
  auto& surface = meshes[mesh.surface.get()];
  if (!surface) surface = std::make_shared<const MeshSurface>(*mesh.surface);
  piece.mesh = surface;
  piece.half = piece.mesh->half_extents();
  piece.capsules = box_capsules(piece.half, false);
  piece.bound = piece.mesh->bound();
  piece.frame = frame_of(pose * Eigen::Translation3d(piece.mesh->center()));
  return piece;
}

}  // namespace

template <>
std::vector<Piece<2>> compile_shape(const Shape& shape, const Pose& pose, MeshCache& /*none*/) {
  const auto cut = planar_cut(shape, pose);
  if (!cut) throw std::invalid_argument(cut.error());
  return std::visit([](const auto& c) { return planar_pieces(c); }, *cut);
}

template <>
std::vector<Piece<3>> compile_shape(const Shape& shape, const Pose& pose, MeshCache& meshes) {
  return {std::visit([&](const auto& s) { return spatial_piece(s, pose, meshes); }, shape)};
}

}  // namespace accord
