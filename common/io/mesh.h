// Meshes of a scene: from files to welded surfaces that all users of a file share.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/io/diagnostic.h"
#include "common/io/file_source.h"
#include "common/io/triangle_soup.h"
#include "common/model/shape.h"

namespace accord {

// Scales, joins corners at equal places into one vertex, and drops triangles without an area. The
// surface is closed where every edge is run through as often one way as the other: watertight, with
// the triangles turned alike. The order of vertices and triangles depends on the soup alone.
TriangleMesh weld(const TriangleSoup& soup, const Vec3& scale);

// Whether three corners make a triangle that is more than a line.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c);

// Whoever named a mesh, to blame for what no line of its file is.
struct MeshBlame {
  Blame file;   // it cannot be read, or holds no mesh
  Blame scale;  // the mesh is too large or too small
};

// The meshes of one scene. Not thread safe.
class MeshStore {
 public:
  // `files` outlives it.
  explicit MeshStore(const FileSource& files = file_system()) : files_(files) {}

  const FileSource& files() const { return files_; }
  // Faults of lines stand in the file itself, others are put to whoever is to blame. Null where
  // there was a fault, which is reported once for each file and scale.
  std::shared_ptr<const TriangleMesh> load(const std::filesystem::path& path, const Vec3& scale,
                                           const MeshBlame& blame, Faults& faults);

 private:
  const FileSource& files_;
  using Key = std::pair<std::string, std::array<double, 3>>;
  std::map<Key, std::shared_ptr<const TriangleMesh>> meshes_;
};

}  // namespace accord
