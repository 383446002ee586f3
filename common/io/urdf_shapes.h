// The <geometry> of URDF: shapes of links.
#pragma once

#include <filesystem>
#include <optional>

#include "common/io/mesh.h"
#include "common/io/xml_reader.h"

namespace accord {

// `geometry` holds exactly one of box, cylinder, sphere, capsule and mesh. Reports faults.
std::optional<Shape> read_urdf_shape(const XmlElement& geometry,
                                     const std::filesystem::path& folder, MeshStore& meshes,
                                     Faults& faults);

}  // namespace accord
