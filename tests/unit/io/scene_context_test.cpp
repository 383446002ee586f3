// What all shapes of a scene together may cost.
#include "common/io/scene_context.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "common/io/limits.h"

namespace accord {
namespace {

TEST(SceneContext, AffordsSoManyTrianglesEachUseCounted) {
  Faults faults("s");
  SceneContext context{.faults = faults, .folder = ""};
  auto surface = std::make_shared<TriangleMesh>();
  surface->triangles.resize(limits::kTriangles);
  const Shape mesh = Mesh{surface};
  std::string blamed;
  const Blame blame = [&](std::string_view text) { blamed = text; };
  for (std::size_t i = 0; i < limits::kSceneTriangles / limits::kTriangles; ++i) {
    EXPECT_TRUE(context.afford(mesh, blame));
  }
  EXPECT_EQ(blamed, "");
  EXPECT_FALSE(context.afford(mesh, blame));
  EXPECT_EQ(blamed,
            "the scene's meshes have more than 2000000 triangles together, each use counted");
}

TEST(SceneContext, AffordsSoManyPointsOfPolygons) {
  Faults faults("s");
  SceneContext context{.faults = faults, .folder = ""};
  const Shape polygon = Polygon{std::vector<Vec2>(limits::kPolygonVertices, Vec2::Zero())};
  std::string blamed;
  const Blame blame = [&](std::string_view text) { blamed = text; };
  for (std::size_t i = 0; i < limits::kVertices / limits::kPolygonVertices; ++i) {
    EXPECT_TRUE(context.afford(polygon, blame));
  }
  EXPECT_FALSE(context.afford(polygon, blame));
  EXPECT_EQ(blamed, "the scene's polygons have more than 200000 points together");
}

}  // namespace
}  // namespace accord
