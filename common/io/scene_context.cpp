#include "common/io/scene_context.h"

#include "common/io/fields.h"
#include "common/io/files.h"
#include "common/io/limits.h"

namespace accord {

std::optional<std::filesystem::path> SceneContext::file_of(const Value& value) {
  const auto name = read_name(value, faults);
  if (!name) return std::nullopt;
  if (folder.empty()) {
    fault_at(value, "a scene that is not a file itself cannot name other files", faults);
    return std::nullopt;
  }
  const auto path = resolve(*name, folder);
  if (!path) {
    fault_at(value, path.error(), faults);
    return std::nullopt;
  }
  return path->lexically_normal();
}

bool SceneContext::afford(const Shape& shape, const Blame& blame) {
  if (const auto* polygon = std::get_if<Polygon>(&shape)) {
    vertices += polygon->vertices.size();
    if (vertices <= limits::kVertices) return true;
    blame("the scene's polygons have more than " + std::to_string(limits::kVertices) +
          " points together");
    return false;
  }
  if (const auto* mesh = std::get_if<Mesh>(&shape)) {
    triangles += mesh->surface->triangles.size();
    if (triangles <= limits::kSceneTriangles) return true;
    blame("the scene's meshes have more than " + std::to_string(limits::kSceneTriangles) +
          " triangles together, each use counted");
    return false;
  }
  return true;
}

}  // namespace accord
