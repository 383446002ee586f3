#include "common/geometry/planar_cut.h"

#include <algorithm>
#include <cmath>

namespace accord {
namespace {

using Cut = tl::expected<PlanarShape, std::string>;

tl::unexpected<std::string> misses() {
  return tl::unexpected<std::string>("does not meet the plane z = 0");
}

tl::unexpected<std::string> oblique(const char* what) {
  return tl::unexpected<std::string>(
      std::string("stands at an angle to the plane z = 0, where a ") + what +
      " must be upright or lie in the plane");
}

// Half the width of a ball's cut at height z; negative where they do not meet.
double ball_cut(double radius, double z) {
  const double squared = (radius - z) * (radius + z);
  return squared < 0 ? -1.0 : std::sqrt(squared);
}

// How an axis (unit) stands to the plane.
enum class Stance { kUpright, kLying, kOblique };

Stance stance(const Vec3& axis) {
  if (axis.head<2>().norm() <= kPlanarTilt) return Stance::kUpright;
  if (std::abs(axis.z()) <= kPlanarTilt) return Stance::kLying;
  return Stance::kOblique;
}

// Where an upright axis through `center` meets the plane.
Vec2 foot(const Vec3& center, const Vec3& axis) {
  return center.head<2>() - axis.head<2>() * (center.z() / axis.z());
}

// The least |z| on a lying axis of half length `half`.
double least_height(const Vec3& center, const Vec3& axis, double half) {
  return std::max(std::abs(center.z()) - half * std::abs(axis.z()), 0.0);
}

// An upright disc tilted by kPlanarTilt is an ellipse longer by half the tilt's square.
constexpr double kEllipse = 1 + kPlanarTilt * kPlanarTilt;

Cut cut(const Sphere& sphere, const Pose& pose) {
  const double radius = ball_cut(sphere.radius, pose.translation().z());
  if (radius < 0) return misses();
  return PlanarDisc{pose.translation().head<2>(), radius};
}

Cut cut(const Capsule& capsule, const Pose& pose) {
  const Vec3 axis = pose.linear().col(2);
  const Vec3 center = pose.translation();
  const double half = capsule.length / 2;
  switch (stance(axis)) {
    case Stance::kUpright: {
      const double above = std::max(std::abs(center.z()) - half, 0.0);
      const double radius = ball_cut(capsule.radius, above);
      if (radius < 0) return misses();
      return PlanarDisc{foot(center, axis), radius * kEllipse};
    }
    case Stance::kLying: {
      const double radius = ball_cut(capsule.radius, least_height(center, axis, half));
      if (radius < 0) return misses();
      const Vec2 reach = half * axis.head<2>();
      return PlanarCapsule{center.head<2>() - reach, center.head<2>() + reach, radius};
    }
    case Stance::kOblique:
      break;
  }
  return oblique("capsule");
}

Cut cut(const Cylinder& cylinder, const Pose& pose) {
  const Vec3 axis = pose.linear().col(2);
  const Vec3 center = pose.translation();
  const double half = cylinder.length / 2;
  switch (stance(axis)) {
    case Stance::kUpright: {
      if (std::abs(center.z()) > half + cylinder.radius * axis.head<2>().norm()) return misses();
      return PlanarDisc{foot(center, axis), cylinder.radius * kEllipse};
    }
    case Stance::kLying: {
      const double width = ball_cut(cylinder.radius, least_height(center, axis, half));
      if (width < 0) return misses();
      const Vec2 u = axis.head<2>().normalized() * (half + cylinder.radius * std::abs(axis.z()));
      const Vec2 v = Vec2(-u.y(), u.x()).normalized() * width;
      const Vec2 c = center.head<2>();
      return PlanarPolygon{{c - u - v, c + u - v, c + u + v, c - u + v}};
    }
    case Stance::kOblique:
      break;
  }
  return oblique("cylinder");
}

// Counter-clockwise hull of a few points (Andrew's monotone chain), without collinear ones.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  std::vector<Vec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();  // the first of the other pass
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

Cut cut(const Box& box, const Pose& pose) {
  const Vec3 half = box.size / 2;
  std::array<Vec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] =
        pose * Vec3((i & 1U) != 0 ? half.x() : -half.x(), (i & 2U) != 0 ? half.y() : -half.y(),
                    (i & 4U) != 0 ? half.z() : -half.z());
  }
  std::vector<Vec2> points;  // where edges cross the plane, and corners in it
  for (unsigned i = 0; i < 8; ++i) {
    if (corners[i].z() == 0) points.push_back(corners[i].head<2>());
    for (unsigned bit = 1; bit < 8; bit <<= 1U) {
      const unsigned j = i | bit;
      if (j == i || corners[i].z() * corners[j].z() >= 0) continue;
      const double u = corners[i].z() / (corners[i].z() - corners[j].z());
      points.push_back((corners[i] + u * (corners[j] - corners[i])).head<2>());
    }
  }
  if (points.empty()) return misses();
  std::vector<Vec2> hull = convex_hull(std::move(points));
  if (hull.size() < 3) return tl::unexpected<std::string>("only touches the plane z = 0");
  return PlanarPolygon{std::move(hull)};
}

Cut cut(const Polygon& polygon, const Pose& pose) {
  const Vec3 normal = pose.linear().col(2);
  if (normal.z() < 0 || normal.head<2>().norm() > kPlanarTilt ||
      std::abs(pose.translation().z()) > kPlanarTilt) {
    return tl::unexpected<std::string>("is a polygon that does not lie in the plane z = 0");
  }
  PlanarPolygon result;
  for (const Vec2& v : polygon.vertices) {
    result.vertices.push_back((pose * Vec3(v.x(), v.y(), 0)).head<2>());
  }
  return result;
}

Cut cut(const Mesh&, const Pose&) {
  return tl::unexpected<std::string>("is a mesh, which planar scenes do not take");
}

}  // namespace

tl::expected<PlanarShape, std::string> planar_cut(const Shape& shape, const Pose& pose) {
  return std::visit([&](const auto& s) { return cut(s, pose); }, shape);
}

}  // namespace accord
