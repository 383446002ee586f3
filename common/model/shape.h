// The shapes that obstacles and robot bodies are made of, as the scene file says them: plain
// values in their own frame, metres. In a planar scene a shape means its cut with the plane z = 0;
// geometry/ does the cutting.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace accord {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Pose = Eigen::Isometry3d;

struct Sphere {
  double radius;
};

// The points within `radius` of a segment of `length` along z, centred. Overall height is
// length + 2 radius.
struct Capsule {
  double radius;
  double length;
};

// Along z, centred, flat ends.
struct Cylinder {
  double radius;
  double length;
};

// Full edge lengths, centred.
struct Box {
  Vec3 size;
};

// A simple polygon in z = 0, convex or not, counter-clockwise. Planar scenes only.
struct Polygon {
  std::vector<Vec2> vertices;
};

// A triangle surface; `closed` (watertight) surfaces are solid.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool closed = false;
};

struct Mesh {
  std::shared_ptr<const TriangleMesh> surface;  // never null; shared by all who use the same file
};

using Shape = std::variant<Sphere, Capsule, Cylinder, Box, Polygon, Mesh>;

}  // namespace accord
