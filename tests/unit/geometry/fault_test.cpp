// What CollisionWorld says to people, and what it knows of insides.
#include "common/geometry/collision_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "common/geometry/tolerances.h"
#include "tests/contract/reference_geometry.h"
#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using namespace test_scenes;

constexpr RobotId kFirst{0};
constexpr RobotId kSecond{1};
constexpr double kPi = std::numbers::pi;

// ---- Messages ----

TEST(Fault, NamesTheObstacleAndTheOverlap) {
  const auto scene = SceneBuilder(true)
                         .clearance(0.05)
                         .obstacle(Box{Vec3(1, 1, 1)}, at(5, 0))
                         .obstacle(Box{Vec3(1, 1, 1)}, at(0, 0))
                         .add(disk(0.5))
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  const auto fault = world.fault(kFirst, Configuration{0.86, 0.1});
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->kind, Fault::Kind::kObstacle);
  EXPECT_EQ(fault->body, "body");
  EXPECT_EQ(fault->other, "obstacle 1");
  EXPECT_NEAR(fault->gap, -0.14, 1e-9);
  EXPECT_LT((fault->where - Vec3(0.5, 0.1, 0)).norm(), 0.3);
  const auto near = world.fault(kFirst, Configuration{1.02, 0});
  ASSERT_TRUE(near.has_value());
  EXPECT_NEAR(near->gap, 0.02, 1e-9);  // apart, but less than the clearance
  const auto centre = world.fault(kFirst, Configuration{0, 0});
  ASSERT_TRUE(centre.has_value());
  EXPECT_NEAR(centre->gap, -1.0, 1e-9);
  EXPECT_FALSE(world.fault(kFirst, Configuration{1.06, 0}).has_value());
}

TEST(Fault, NamesBoundsBodiesAndOtherRobots) {
  const auto scene = SceneBuilder(true)
                         .bounds({-3.5, -3.5, 0}, {3.5, 3.5, 0})
                         .add(planar_arm(), at(-1, 0))
                         .add(planar_arm(), at(1, 0))
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  const auto bounds = world.fault(kFirst, Configuration{3.1, 0, 0});
  ASSERT_TRUE(bounds.has_value());
  EXPECT_EQ(bounds->kind, Fault::Kind::kBounds);
  EXPECT_EQ(bounds->body, "link3");
  const double tip = -1 + 3 * std::cos(3.1) - 0.06 * std::sin(3.1);
  EXPECT_NEAR(bounds->gap, -(-3.5 - tip), 1e-9);
  const auto self = world.fault(kFirst, Configuration{0, 2.5, 2.5});
  ASSERT_TRUE(self.has_value());
  EXPECT_EQ(self->kind, Fault::Kind::kSelf);
  EXPECT_EQ(self->body, "link1");
  EXPECT_EQ(self->other, "link3");
  EXPECT_LT(self->gap, 0);
  const Fault robots =
      world.closest(kFirst, Configuration{0, 0, 0}, kSecond, Configuration{kPi / 2, 0, 0});
  EXPECT_EQ(robots.kind, Fault::Kind::kRobot);
  EXPECT_EQ(robots.body, "link2");
  EXPECT_EQ(robots.other, "r1: link1");
  EXPECT_LT(robots.gap, 0);
  EXPECT_LT((robots.where - Vec3(1, 0, 0)).norm(), 0.3);
}

TEST(CollisionWorld, SaysWhyASceneHasNoGeometry) {
  const auto scene = SceneBuilder(true).obstacle(Cylinder{0.1, 1}, at(0, 0, 0, 0.5)).build();
  try {
    const CollisionWorld world(scene, 0);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "obstacle \"obstacle 0\" stands at an angle to the plane z = 0, where a cylinder must "
        "be upright or lie in the plane");
  }
}

// ---- Solid meshes ----

TEST(SolidMesh, HoldsWhatIsInside) {
  const auto scene = SceneBuilder(false)
                         .obstacle(Mesh{box_mesh(Vec3(2, 2, 2))}, at(0, 0, 0, 0.2, 0.3, 0.4))
                         .add(ball(0.1))
                         .add(ball(0.2))
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  const Configuration inside{0.1, 0, 0};
  EXPECT_FALSE(world.is_free(kFirst, inside));
  EXPECT_FALSE(world.motion_is_free(kFirst, inside, Configuration{0.2, 0, 0}));
  EXPECT_EQ(world.first_fault(kFirst, inside, Configuration{0.2, 0, 0}), 0.0);
  EXPECT_EQ(world.obstacle_distance(kFirst, inside, 1), 0);
  const auto fault = world.fault(kFirst, inside);
  ASSERT_TRUE(fault.has_value());
  EXPECT_LT(fault->gap, -0.5);
  EXPECT_TRUE(world.is_free(kFirst, Configuration{3, 0, 0}));
}

TEST(SolidMesh, OfARobotHoldsOtherRobots) {
  auto model = std::make_shared<RobotModel>(*odd_arm());
  model->bodies[4].shape = Mesh{box_mesh(Vec3(1, 1, 1))};
  const auto scene = SceneBuilder(false).add(model).add(ball(0.05)).build();
  const CollisionWorld world(scene, kPlanningMargin);
  const Configuration zero{0, 0, 0, 0};
  const Vec3 center =
      (reference::link_poses(scene->robots[0], zero)[4] * model->bodies[4].pose).translation();
  const Configuration inside{center.x(), center.y(), center.z()};
  EXPECT_FALSE(world.are_clear(kFirst, zero, kSecond, inside));
  EXPECT_FALSE(world.are_clear(kSecond, inside, kFirst, zero));
  EXPECT_EQ(world.separation(kFirst, zero, kSecond, inside, 1), 0);
  EXPECT_LT(world.closest(kFirst, zero, kSecond, inside).gap, 0);
}

}  // namespace
}  // namespace accord
