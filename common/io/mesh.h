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
#include "common/io/triangle_soup.h"
#include "common/model/shape.h"

namespace accord {

// Scales, joins corners at equal places into one vertex, and drops triangles without an area. The
// surface is closed where every edge is run through as often one way as the other: watertight, with
// the triangles turned alike. The order of vertices and triangles depends on the soup alone.
TriangleMesh weld(const TriangleSoup& soup, const Vec3& scale);

// The meshes of one scene. Not thread safe.
class MeshStore {
 public:
  // `blame` is called where the file is missing or of an unknown kind; other faults stand in the
  // file itself. Null where there was a fault, which is reported once for each file and scale.
  std::shared_ptr<const TriangleMesh> load(const std::filesystem::path& path, const Vec3& scale,
                                           const Blame& blame, Faults& faults);

 private:
  using Key = std::pair<std::string, std::array<double, 3>>;
  std::map<Key, std::shared_ptr<const TriangleMesh>> meshes_;
};

}  // namespace accord
