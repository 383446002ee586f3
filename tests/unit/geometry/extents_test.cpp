// CollisionWorld on distances and extents.
#include "common/geometry/collision_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/tolerances.h"
#include "tests/contract/reference_geometry.h"
#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using namespace test_scenes;

constexpr RobotId kFirst{0};
constexpr RobotId kSecond{1};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- Distances ----

TEST(Distances, AreTightAndNeverTooLarge) {
  const auto scene = SceneBuilder(false)
                         .obstacle(Box{Vec3(0.4, 0.1, 0.6)}, at(0.6, 0.4, 0.4, 0.1, 0.2, 0.3))
                         .obstacle(Cylinder{0.15, 0.8}, at(-0.6, 0.2, 0.4))
                         .obstacle(Mesh{ring_mesh(0.3, 0.35, 0.05, 8)}, at(0, 0, 1.2))
                         .add(six_joint_arm())
                         .add(odd_arm(), at(0.7, -0.5, 0))
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  Random random(5);
  for (int k = 0; k < 30; ++k) {
    const auto a = random_configuration(*scene->robots[0].model, random, 3);
    const auto b = random_configuration(*scene->robots[1].model, random, 3);
    const auto to_robot = reference::robot_distance(*scene, kFirst, a, kSecond, b);
    const double separation = world.separation(kFirst, a, kSecond, b, kInfinity);
    EXPECT_LE(separation, to_robot.upper);
    EXPECT_GE(separation, to_robot.lower - 1e-6);
    EXPECT_EQ(world.separation(kFirst, a, kSecond, b, 1e-3), std::min(separation, 1e-3));
    const auto to_obstacle = reference::obstacle_distance(*scene, kFirst, a);
    const double distance = world.obstacle_distance(kFirst, a, kInfinity);
    EXPECT_LE(distance, to_obstacle.upper);
    EXPECT_GE(distance, to_obstacle.lower - 1e-6);
    EXPECT_NEAR(world.closest(kFirst, a, kSecond, b).gap, separation, separation > 0 ? 1e-6 : 2);
  }
}

TEST(Distances, AreCutOffWithoutObstacles) {
  const CollisionWorld world(SceneBuilder(true).add(disk(1)).build(), 0);
  EXPECT_EQ(world.obstacle_distance(kFirst, Configuration{0, 0}, 3.5), 3.5);
}

// ---- Extents ----

template <typename Model>
void expect_swept_bounds_hold(const std::shared_ptr<const Scene>& scene, const Model& model,
                              double slack) {
  const CollisionWorld world(scene, 0);
  Random random(6);
  for (int k = 0; k < 60; ++k) {
    const auto a = random_configuration(*model, random, 3);
    auto b = a;
    for (double& value : b) value += uniform(random, -0.5, 0.5);
    const Aabb bounds = world.swept_bounds(kFirst, a, b);
    Vec3 low = Vec3::Constant(kInfinity);
    Vec3 high = -low;
    for (int i = 0; i <= 20; ++i) {
      for (const auto& body :
           reference::bodies(*scene, kFirst, reference::between(a, b, i / 20.0))) {
        for (int axis = 0; axis < (scene->planar ? 2 : 3); ++axis) {
          for (const auto& set : body) {
            high[axis] = std::max(high[axis], set->support(Vec3::Unit(axis))[axis]);
            low[axis] = std::min(low[axis], set->support(-Vec3::Unit(axis))[axis]);
          }
        }
      }
    }
    for (int axis = 0; axis < (scene->planar ? 2 : 3); ++axis) {
      EXPECT_GE(bounds.max[axis], high[axis] - 1e-12);
      EXPECT_LE(bounds.min[axis], low[axis] + 1e-12);
      EXPECT_LE(bounds.max[axis], high[axis] + slack);
      EXPECT_GE(bounds.min[axis], low[axis] - slack);
    }
  }
}

TEST(SweptBounds, HoldTheWholeMotionAndLittleMore) {
  const auto disc = disk(0.3);
  expect_swept_bounds_hold(SceneBuilder(true).add(disc).build(), disc, 1e-12);
  const auto cart = footprint(ell());
  expect_swept_bounds_hold(SceneBuilder(true).add(cart).build(), cart, 0.1);
  const auto arm = planar_arm();
  expect_swept_bounds_hold(SceneBuilder(true).add(arm).build(), arm, 1.0);
  const auto six = six_joint_arm();
  expect_swept_bounds_hold(SceneBuilder(false).add(six, at(1, 2, 3)).build(), six, 0.8);
}

TEST(Extents, ReachAndRadius) {
  const auto scene = SceneBuilder(true)
                         .add(disk(0.3))
                         .add(footprint(rectangle(0.8, 0.6)))
                         .add(planar_arm())
                         .build();
  const CollisionWorld world(scene, 0);
  EXPECT_EQ(world.radius(kFirst), 0.3);
  EXPECT_EQ(world.radius(kSecond), std::nullopt);
  EXPECT_NEAR(world.reach(kSecond)[2], 0.5, 1e-12);
  const auto reach = world.reach(RobotId{2});
  EXPECT_NEAR(reach[0], 2 + std::hypot(1, 0.06), 1e-12);
  EXPECT_NEAR(reach[2], std::hypot(1, 0.06), 1e-12);
}

}  // namespace
}  // namespace accord
