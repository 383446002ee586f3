#include "common/io/wire/shape_decoder.h"

#include "accord.pb.h"
#include "common/io/mesh.h"
#include "common/io/polygon.h"
#include "common/io/words.h"

namespace accord {
namespace {

// A mesh's spatial extent: the file's readers bound coordinates, and how small it may be.
double largest_extent(const std::vector<Vec3>& vertices) {
  Vec3 low = vertices.front();
  Vec3 high = low;
  for (const Vec3& vertex : vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  return (high - low).maxCoeff();
}

}  // namespace

bool ShapeDecoder::take_meshes(const payload::Scene& from) {
  const auto size = static_cast<std::size_t>(from.meshes_size());
  if (!inspector_.count(size, 0, limits::kObstacles, "", PayloadPath("meshes"))) return false;
  for (std::size_t i = 0; i < size; ++i) {
    auto mesh = std::make_shared<TriangleMesh>();
    if (!take_mesh(from.meshes(static_cast<int>(i)), PayloadPath("meshes", i), *mesh)) return false;
    meshes_.push_back(std::move(mesh));
  }
  return true;
}

bool ShapeDecoder::take_mesh(const payload::Mesh& from, const PayloadPath& at, TriangleMesh& out) {
  const PayloadPath vertices(at, "vertices");
  const auto numbers = static_cast<std::size_t>(from.vertices_size());
  if (!inspector_.count(numbers / 3, 3, 3 * limits::kTriangles, "vertices", vertices) ||
      !inspector_.numbers(from.vertices(), numbers / 3 * 3, kCoordinateRange, vertices)) {
    return false;
  }
  const double* next = from.vertices().data();
  out.vertices.reserve(numbers / 3);
  for (std::size_t i = 0; i < numbers / 3; ++i, next += 3) {
    out.vertices.emplace_back(next[0], next[1], next[2]);
  }
  const double extent = largest_extent(out.vertices);
  if (extent < limits::kMinSize) {
    return inspector_.fail(at, "measures no more than " + in_words(extent) + " m");
  }
  out.closed = from.closed();
  return take_triangles(from, at, out);
}

bool ShapeDecoder::take_triangles(const payload::Mesh& from, const PayloadPath& at,
                                  TriangleMesh& out) {
  const PayloadPath triangles(at, "triangles");
  const auto corners = static_cast<std::size_t>(from.triangles_size());
  if (corners % 3 != 0) return inspector_.fail(triangles, "expected three corners each");
  if (!inspector_.count(corners / 3, 1, limits::kTriangles, "triangles", triangles)) return false;
  out.triangles.reserve(corners / 3);
  for (std::size_t i = 0; i < corners / 3; ++i) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = from.triangles(static_cast<int>(3 * i + k));
      if (!inspector_.index(triangle[k], out.vertices.size(), "vertex",
                            PayloadPath(triangles, "", 3 * i + k))) {
        return false;
      }
    }
    if (!has_area(out.vertices[triangle[0]], out.vertices[triangle[1]],
                  out.vertices[triangle[2]])) {
      return inspector_.fail(PayloadPath(triangles, "", 3 * i), "a triangle without an area");
    }
    out.triangles.push_back(triangle);
  }
  return true;
}

bool ShapeDecoder::take(const payload::Shape& from, bool planar, const PayloadPath& at,
                        Shape& out) {
  const auto round = [&](const payload::RoundShape& shape) {
    return inspector_.number(shape.radius(), kSizeRange, PayloadPath(at, "radius")) &&
           inspector_.number(shape.length(), kSizeRange, PayloadPath(at, "length"));
  };
  switch (from.kind_case()) {
    case payload::Shape::kSphere:
      out = Sphere{from.sphere()};
      return inspector_.number(from.sphere(), kSizeRange, PayloadPath(at, "sphere"));
    case payload::Shape::kCapsule:
      out = Capsule{from.capsule().radius(), from.capsule().length()};
      return round(from.capsule());
    case payload::Shape::kCylinder:
      out = Cylinder{from.cylinder().radius(), from.cylinder().length()};
      return round(from.cylinder());
    case payload::Shape::kBox: {
      const WireDoubles& size = from.box().value();
      if (!inspector_.numbers(size, 3, kSizeRange, PayloadPath(at, "box"))) return false;
      out = Box{{size[0], size[1], size[2]}};
      return true;
    }
    case payload::Shape::kPolygon: {
      if (!planar) return inspector_.fail(at, "polygons are for planar scenes");
      Polygon polygon;
      if (!take_polygon(from.polygon().value(), PayloadPath(at, "polygon"), polygon)) return false;
      out = std::move(polygon);
      return true;
    }
    case payload::Shape::kMesh:
      if (planar) return inspector_.fail(at, "meshes are for spatial scenes");
      return use_mesh(from.mesh(), PayloadPath(at, "mesh"), out);
    case payload::Shape::KIND_NOT_SET:
      break;
  }
  return inspector_.fail(at, "expected a shape");
}

bool ShapeDecoder::take_polygon(const WireDoubles& from, const PayloadPath& at, Polygon& out) {
  const auto points = static_cast<std::size_t>(from.size()) / 2;
  vertices_ += points;
  if (!inspector_.count(points, 3, limits::kPolygonVertices, "points", at) ||
      !inspector_.count(vertices_, 0, limits::kVertices, "points of all polygons", at) ||
      !inspector_.numbers(from, 2 * points, kCoordinateRange, at)) {
    return false;
  }
  for (std::size_t i = 0; i < points; ++i) {
    out.vertices.emplace_back(from[static_cast<int>(2 * i)], from[static_cast<int>(2 * i + 1)]);
  }
  if (const auto fault = outline_fault(out.vertices)) return inspector_.fail(at, *fault);
  return signed_area(out.vertices) > 0 || inspector_.fail(at, "expected counter-clockwise");
}

bool ShapeDecoder::use_mesh(std::uint32_t index, const PayloadPath& at, Shape& out) {
  if (!inspector_.index(index, meshes_.size(), "mesh", at)) return false;
  triangles_ += meshes_[index]->triangles.size();
  out = Mesh{meshes_[index]};
  return inspector_.count(triangles_, 0, limits::kSceneTriangles,
                          "triangles of all meshes, each use counted", at);
}

}  // namespace accord
