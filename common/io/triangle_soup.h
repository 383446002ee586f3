// Triangles as mesh files list them, and the readers for the two formats: STL and OBJ. Written here
// rather than taken from an import library: these report faults with their line, and hold on to
// nothing but what the file's size allows.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/model/shape.h"

namespace accord {

using TriangleSoup = std::vector<std::array<Vec3, 3>>;

// STL, text or binary. All coordinates of the result are finite. At most kTriangles. Every line at
// fault is reported, up to kLineFaults; what has no line, whoever named the file is blamed for,
// with its name. Thread safe.
std::optional<TriangleSoup> parse_stl(std::string_view bytes, const std::string& file,
                                      const Blame& blame, Faults& faults);

// Wavefront OBJ: `v` and `f` count, faces of more corners are cut into triangles where they are
// convex, what only decorates is passed over. As above otherwise.
std::optional<TriangleSoup> parse_obj(std::string_view text, const std::string& file,
                                      Faults& faults);

}  // namespace accord
