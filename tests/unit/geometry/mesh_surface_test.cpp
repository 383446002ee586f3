#include "common/geometry/mesh_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using namespace test_scenes;

TEST(MeshSurface, KnowsItsInside) {
  const MeshSurface ring(*ring_mesh(0.5, 1.0, 0.4, 64));
  Random random(1);
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p(uniform(random, -1.2, 1.2), uniform(random, -1.2, 1.2),
                 uniform(random, -0.3, 0.3));
    const double out = p.head<2>().norm();
    const double chord = std::cos(3.14159265 / 64);  // the sides are flat
    if (out > 0.5 && out < 1.0 * chord && std::abs(p.z()) < 0.2) {
      EXPECT_TRUE(ring.contains(p));
      ++inside;
    }
    if (out < 0.5 * chord || out > 1.0 || std::abs(p.z()) > 0.2) {
      EXPECT_FALSE(ring.contains(p));
    }
  }
  EXPECT_GT(inside, 300);
}

TEST(MeshSurface, OpenSurfacesHaveNoInside) {
  TriangleMesh open = *box_mesh(Vec3(1, 1, 1));
  open.closed = false;
  EXPECT_FALSE(MeshSurface(open).contains(Vec3::Zero()));
}

TEST(MeshSurface, IsCentredOnItsBox) {
  TriangleMesh mesh = *box_mesh(Vec3(1, 2, 3));
  for (Vec3& v : mesh.vertices) v += Vec3(7, 8, 9);
  const MeshSurface surface(mesh);
  EXPECT_LT((surface.center() - Vec3(7, 8, 9)).norm(), 1e-12);
  EXPECT_LT((surface.half_extents() - Vec3(0.5, 1, 1.5)).norm(), 1e-12);
  EXPECT_NEAR(surface.bound(), Vec3(0.5, 1, 1.5).norm(), 1e-12);
  EXPECT_TRUE(surface.contains(Vec3::Zero()));
}

}  // namespace
}  // namespace accord
