// The cut of a shape with the plane z = 0: what shapes mean in a planar scene (formats.md). io uses
// it to reject shapes that have none, geometry to compile those that do. Pure functions.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "common/model/shape.h"

namespace accord {

struct PlanarDisc {
  Vec2 center;
  double radius;
};

// The points within `radius` of the segment from a to b.
struct PlanarCapsule {
  Vec2 a;
  Vec2 b;
  double radius;
};

// Simple, counter-clockwise; convex unless it comes from a Polygon that is not.
struct PlanarPolygon {
  std::vector<Vec2> vertices;
};

using PlanarShape = std::variant<PlanarDisc, PlanarCapsule, PlanarPolygon>;

// Angles up to this count as parallel or perpendicular to the plane: URDF files write 1.570796.
// What is cut then is the exact cut or contains it.
inline constexpr double kPlanarTilt = 1e-5;  // rad

// The cut of `shape` at `pose` (which maps the shape's frame to one whose z = 0 is the plane).
// Boxes may stand at any angle; cylinders and capsules upright or lying in the plane. Otherwise,
// and for meshes and shapes that do not meet the plane: a sentence without its subject, such as
// "does not meet the plane z = 0".
tl::expected<PlanarShape, std::string> planar_cut(const Shape& shape, const Pose& pose);

}  // namespace accord
