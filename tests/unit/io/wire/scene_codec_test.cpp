// Scenes come back from their bytes bit for bit, whatever they hold.
#include "common/io/wire/scene_codec.h"

#include <gtest/gtest.h>

#include <bit>
#include <map>

#include "common/io/wire/scene_hash.h"
#include "tests/unit/io/wire/wire_samples.h"

namespace accord {
namespace {

using namespace wire_samples;

// ---- Equality to the bit, written apart from the codec ----

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(std::span<const double> a, std::span<const double> b) {
  return std::ranges::equal(a, b, [](double x, double y) { return same(x, y); });
}

bool same(const Vec3& a, const Vec3& b) {
  return same(std::span(a.data(), 3), std::span(b.data(), 3));
}

bool same(const Pose& a, const Pose& b) {
  return same(std::span(a.data(), 16), std::span(b.data(), 16));
}

bool same(const TriangleMesh& a, const TriangleMesh& b) {
  return std::ranges::equal(a.vertices, b.vertices,
                            [](const Vec3& x, const Vec3& y) { return same(x, y); }) &&
         a.triangles == b.triangles && a.closed == b.closed;
}

bool same(const Sphere& a, const Sphere& b) {
  return same(a.radius, b.radius);
}
bool same(const Capsule& a, const Capsule& b) {
  return same(a.radius, b.radius) && same(a.length, b.length);
}
bool same(const Cylinder& a, const Cylinder& b) {
  return same(a.radius, b.radius) && same(a.length, b.length);
}
bool same(const Box& a, const Box& b) {
  return same(a.size, b.size);
}
bool same(const Polygon& a, const Polygon& b) {
  return std::ranges::equal(a.vertices, b.vertices, [](const Vec2& x, const Vec2& y) {
    return same(std::span(x.data(), 2), std::span(y.data(), 2));
  });
}
bool same(const Mesh& a, const Mesh& b) {
  return same(*a.surface, *b.surface);
}
bool same(const Shape& a, const Shape& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& kind) { return same(kind, std::get<std::decay_t<decltype(kind)>>(b)); }, a);
}

void expect_same(const RobotModel& a, const RobotModel& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_TRUE(same(a.speed, b.speed));
  EXPECT_EQ(a.links, b.links);
  EXPECT_EQ(a.may_touch, b.may_touch);
  ASSERT_EQ(a.dofs.size(), b.dofs.size());
  for (std::size_t i = 0; i < a.dofs.size(); ++i) {
    EXPECT_EQ(a.dofs[i].name, b.dofs[i].name);
    EXPECT_TRUE(same(a.dofs[i].lower, b.dofs[i].lower));
    EXPECT_TRUE(same(a.dofs[i].upper, b.dofs[i].upper));
    EXPECT_TRUE(same(a.dofs[i].velocity, b.dofs[i].velocity));
    EXPECT_EQ(a.dofs[i].wraps, b.dofs[i].wraps);
  }
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    EXPECT_EQ(a.joints[i].name, b.joints[i].name);
    EXPECT_EQ(a.joints[i].type, b.joints[i].type);
    EXPECT_EQ(a.joints[i].parent, b.joints[i].parent);
    EXPECT_EQ(a.joints[i].child, b.joints[i].child);
    EXPECT_TRUE(same(a.joints[i].origin, b.joints[i].origin));
    EXPECT_TRUE(same(a.joints[i].axis, b.joints[i].axis));
    EXPECT_EQ(a.joints[i].dof, b.joints[i].dof);
  }
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    EXPECT_EQ(a.bodies[i].name, b.bodies[i].name);
    EXPECT_EQ(a.bodies[i].link, b.bodies[i].link);
    EXPECT_TRUE(same(a.bodies[i].shape, b.bodies[i].shape));
    EXPECT_TRUE(same(a.bodies[i].pose, b.bodies[i].pose));
  }
}

void expect_same(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_TRUE(same(a.timestep, b.timestep));
  EXPECT_TRUE(same(a.clearance, b.clearance));
  EXPECT_EQ(a.planar, b.planar);
  ASSERT_EQ(a.bounds.has_value(), b.bounds.has_value());
  if (a.bounds && b.bounds) {
    EXPECT_TRUE(same(a.bounds->min, b.bounds->min));
    EXPECT_TRUE(same(a.bounds->max, b.bounds->max));
  }
  ASSERT_EQ(a.obstacles.size(), b.obstacles.size());
  for (std::size_t i = 0; i < a.obstacles.size(); ++i) {
    EXPECT_EQ(a.obstacles[i].name, b.obstacles[i].name);
    EXPECT_TRUE(same(a.obstacles[i].shape, b.obstacles[i].shape));
    EXPECT_TRUE(same(a.obstacles[i].pose, b.obstacles[i].pose));
  }
  ASSERT_EQ(a.robots.size(), b.robots.size());
  std::map<const RobotModel*, const RobotModel*> models;
  for (std::size_t i = 0; i < a.robots.size(); ++i) {
    EXPECT_EQ(a.robots[i].name, b.robots[i].name);
    EXPECT_TRUE(same(a.robots[i].base, b.robots[i].base));
    EXPECT_TRUE(same(a.robots[i].start, b.robots[i].start));
    EXPECT_TRUE(same(a.robots[i].goal, b.robots[i].goal));
    const auto [model, is_new] = models.emplace(a.robots[i].model.get(), b.robots[i].model.get());
    EXPECT_EQ(model->second, b.robots[i].model.get()) << "models are shared alike";
    if (is_new) expect_same(*a.robots[i].model, *b.robots[i].model);
  }
}

class ExampleSceneOnTheWire : public testing::TestWithParam<std::string> {};

TEST_P(ExampleSceneOnTheWire, ComesBackToTheBit) {
  const auto scene = load_example(GetParam());
  ASSERT_NE(scene, nullptr);
  const Bytes bytes = encode_scene(*scene);
  const auto decoded = decode_scene(bytes);
  ASSERT_TRUE(decoded) << decoded.error();
  expect_same(*scene, **decoded);
  // The same bytes from another copy, whose models and meshes lie elsewhere.
  EXPECT_EQ(encode_scene(**decoded), bytes);
  EXPECT_EQ(encode_scene(*load_example(GetParam())), bytes);
}

INSTANTIATE_TEST_SUITE_P(All, ExampleSceneOnTheWire, testing::ValuesIn(example_scenes()),
                         [](const auto& param_info) {
                           std::string name =
                               param_info.param.substr(0, param_info.param.size() - 5);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(SceneCodec, KeepsAMeshThatShapesShare) {
  const auto scene = load_example("rack-drones.yaml");
  ASSERT_NE(scene, nullptr);
  const auto decoded = decode_scene(encode_scene(*scene));
  ASSERT_TRUE(decoded) << decoded.error();
  std::map<const TriangleMesh*, const TriangleMesh*> meshes;
  for (std::size_t i = 0; i < scene->obstacles.size(); ++i) {
    const auto* mesh = std::get_if<Mesh>(&scene->obstacles[i].shape);
    if (mesh == nullptr) continue;
    const auto& copy = std::get<Mesh>((*decoded)->obstacles[i].shape);
    EXPECT_EQ(meshes.emplace(mesh->surface.get(), copy.surface.get()).first->second,
              copy.surface.get());
  }
  EXPECT_FALSE(meshes.empty());
}

TEST(SceneCodec, TellsScenesApartByTheLeastOfTheirBits) {
  Scene scene = *small_scene();
  const SceneHash hash = hash_of(encode_scene(scene));
  scene.robots[1].goal[0] = std::nextafter(scene.robots[1].goal[0], 0);
  EXPECT_NE(hash_of(encode_scene(scene)), hash);
}

}  // namespace
}  // namespace accord
