#include "common/geometry/planar_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using test_scenes::at;
constexpr double kHalfPi = std::numbers::pi / 2;

double area(const PlanarPolygon& polygon) {
  double twice = 0;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec2& a = v[i];
    const Vec2& b = v[(i + 1) % v.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

template <typename T>
T cut_of(const Shape& shape, const Pose& pose) {
  const auto cut = planar_cut(shape, pose);
  EXPECT_TRUE(cut.has_value()) << (cut ? "" : cut.error());
  if (!cut || !std::holds_alternative<T>(*cut)) {
    ADD_FAILURE() << "another kind of cut";
    return T{};
  }
  return std::get<T>(*cut);
}

std::string error_of(const Shape& shape, const Pose& pose) {
  const auto cut = planar_cut(shape, pose);
  return cut ? "none" : cut.error();
}

TEST(PlanarCut, OfASphereShrinksWithItsHeight) {
  const auto disc = cut_of<PlanarDisc>(Sphere{0.5}, at(1, 2, 0.3));
  EXPECT_NEAR(disc.radius, 0.4, 1e-15);
  EXPECT_EQ(disc.center, Vec2(1, 2));
  EXPECT_EQ(error_of(Sphere{0.5}, at(0, 0, 0.51)), "does not meet the plane z = 0");
}

TEST(PlanarCut, OfAnUprightBoxIsItsBase) {
  const auto polygon = cut_of<PlanarPolygon>(Box{Vec3(2, 1, 1)}, at(1, 0, 0.5, 0, 0, 0.3));
  EXPECT_EQ(polygon.vertices.size(), 4U);
  EXPECT_NEAR(area(polygon), 2, 1e-12);
}

TEST(PlanarCut, OfATiltedBoxIsItsTrueSection) {
  // A cube on its corner: the cut through its middle is a regular hexagon.
  Pose pose = Pose::Identity();
  pose.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vec3(1, 1, 1), Vec3::UnitZ()).toRotationMatrix();
  const auto polygon = cut_of<PlanarPolygon>(Box{Vec3(1, 1, 1)}, pose);
  EXPECT_EQ(polygon.vertices.size(), 6U);
  EXPECT_NEAR(area(polygon), 3 * std::sqrt(3.0) / 4, 1e-12);
  EXPECT_EQ(error_of(Box{Vec3(1, 1, 1)}, at(0, 0, 1)), "does not meet the plane z = 0");
}

TEST(PlanarCut, OfAnUprightCylinderIsADiscEvenIfUrdfRoundsItsAngles) {
  const auto disc = cut_of<PlanarDisc>(Cylinder{0.3, 2}, at(1, 2, 0.9, 3.141593));
  EXPECT_GE(disc.radius, 0.3);
  EXPECT_NEAR(disc.radius, 0.3, 1e-9);
  EXPECT_NEAR(disc.center.y(), 2, 1e-6);
}

TEST(PlanarCut, OfALyingCylinderIsARectangleThatHoldsTheTrueCut) {
  const auto polygon = cut_of<PlanarPolygon>(Cylinder{0.5, 2}, at(0, 0, 0.3, 1.570796));
  EXPECT_GE(area(polygon), 2 * 0.8);
  EXPECT_NEAR(area(polygon), 2 * 0.8, 1e-5);
}

TEST(PlanarCut, OfCapsules) {
  const auto lying = cut_of<PlanarCapsule>(Capsule{0.5, 2}, at(0, 0, 0.3, kHalfPi, 0, 0));
  EXPECT_NEAR(lying.radius, 0.4, 1e-12);
  EXPECT_NEAR((lying.a - lying.b).norm(), 2, 1e-12);
  const auto upright = cut_of<PlanarDisc>(Capsule{0.5, 2}, at(0, 0, 1.3));
  EXPECT_NEAR(upright.radius, 0.4, 1e-9);
  EXPECT_NEAR(cut_of<PlanarDisc>(Capsule{0.5, 2}, at(0, 0, 0.9)).radius, 0.5, 1e-9);
}

TEST(PlanarCut, OfPolygonsKeepsTheirShape) {
  const auto polygon = cut_of<PlanarPolygon>(Polygon{test_scenes::ell()}, at(5, 6, 0, 0, 0, 1.1));
  EXPECT_EQ(polygon.vertices.size(), 6U);
  EXPECT_NEAR(area(polygon), 0.6 + 0.35, 1e-12);
  EXPECT_NE(error_of(Polygon{test_scenes::ell()}, at(0, 0, 0.1)), "none");
}

TEST(PlanarCut, SaysWhatHasNoCut) {
  EXPECT_EQ(error_of(Cylinder{0.1, 1}, at(0, 0, 0, 0.3)),
            "stands at an angle to the plane z = 0, where a cylinder must be upright or lie in the "
            "plane");
  EXPECT_NE(error_of(Capsule{0.1, 1}, at(0, 0, 0, 0.3)), "none");
  EXPECT_EQ(error_of(Mesh{test_scenes::box_mesh(Vec3(1, 1, 1))}, at(0, 0)),
            "is a mesh, which planar scenes do not take");
}

}  // namespace
}  // namespace accord
