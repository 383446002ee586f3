// Shapes and meshes of a scene from its payload. For scene_decoder.cpp and model_decoder.cpp.
#pragma once

#include <memory>
#include <vector>

#include "common/io/wire/inspector.h"
#include "common/model/shape.h"

namespace accord::payload {
class Mesh;
class Scene;
class Shape;
}  // namespace accord::payload

namespace accord {

// Not thread safe.
class ShapeDecoder {
 public:
  explicit ShapeDecoder(Inspector& inspector) : inspector_(inspector) {}

  // First, for take() to find them. Surfaces are sound: within limits, with triangles that have
  // areas.
  bool take_meshes(const payload::Scene& from);

  // Polygons are for planar scenes, meshes for spatial ones. Counts towards what all shapes of a
  // scene may cost together.
  bool take(const payload::Shape& from, bool planar, const PayloadPath& at, Shape& out);

 private:
  bool take_mesh(const payload::Mesh& from, const PayloadPath& at, TriangleMesh& out);
  bool take_triangles(const payload::Mesh& from, const PayloadPath& at, TriangleMesh& out);
  bool take_polygon(const WireDoubles& from, const PayloadPath& at, Polygon& out);
  bool use_mesh(std::uint32_t index, const PayloadPath& at, Shape& out);

  Inspector& inspector_;
  std::vector<std::shared_ptr<const TriangleMesh>> meshes_;
  std::size_t vertices_ = 0;   // of all polygons
  std::size_t triangles_ = 0;  // of all uses of meshes
};

}  // namespace accord
