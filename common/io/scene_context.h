// What the readers of a scene's parts share during one load.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

#include "common/io/diagnostic.h"
#include "common/io/document.h"
#include "common/io/file_source.h"
#include "common/io/mesh.h"
#include "common/io/pose_fields.h"
#include "common/model/scene.h"

namespace accord {

struct SceneContext {
  Faults& faults;
  // Where in `files` those lie that the scene names; empty: it may name none.
  std::filesystem::path folder;
  const FileSource& files = file_system();
  Space space = Space::kUnknown;
  bool bounds_given = false;          // soundly or not
  std::optional<Bounds> bounds = {};  // where sound
  MeshStore meshes = MeshStore(files);

  // Spent so far; see limits.h.
  std::size_t vertices = 0;
  std::size_t triangles = 0;

  // The file that a value names, or nullopt after a report.
  std::optional<std::filesystem::path> file_of(const Value& value);
  // Counts what a shape costs; false, after blaming somebody, where that is too much.
  bool afford(const Shape& shape, const Blame& blame);
};

}  // namespace accord
