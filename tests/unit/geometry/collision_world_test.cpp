// CollisionWorld case by case; tests/contract holds it against sampling at large.
#include "common/geometry/collision_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <thread>

#include "common/geometry/tolerances.h"
#include "tests/contract/reference_geometry.h"
#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using namespace test_scenes;

constexpr RobotId kFirst{0};
constexpr RobotId kSecond{1};
constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::optional<double> contact(const CollisionWorld& world, const Configuration& a0,
                              const Configuration& a1, const Configuration& b0,
                              const Configuration& b1) {
  return world.first_contact(kFirst, {a0, a1, 0, 1}, kSecond, {b0, b1, 0, 1});
}

// ---- Tunnelling ----

TEST(CollisionWorld, NothingPassesThroughAThinWall) {
  const auto planar = SceneBuilder(true).obstacle(Box{Vec3(1e-6, 2, 1)}, at(0, 0));
  const auto spatial = SceneBuilder(false).obstacle(Box{Vec3(1e-6, 2, 2)}, at(0, 0));
  struct Case {
    std::shared_ptr<const Scene> scene;
    Configuration from;
    Configuration to;
  };
  const std::vector<Case> cases{
      {SceneBuilder(planar).add(disk(0.01)).build(), {-100, 0.3}, {90, 0.1}},
      {SceneBuilder(planar).add(footprint(rectangle(0.02, 0.01))).build(),
       {-100, 0.3, 0},
       {90, 0.1, 50}},
      {SceneBuilder(planar).add(planar_arm(), at(-1, 0)).build(), {1.5, 0, 0}, {-1.5, 0, 0}},
      {SceneBuilder(spatial).add(ball(0.01)).build(), {-100, 0.3, 0}, {90, 0.1, 0.2}},
      {SceneBuilder(spatial).add(six_joint_arm(), at(-0.3, 0, 0)).build(),
       {-1.5, 1.5, 0, 0, 0, 0},
       {1.5, 1.5, 0, 0, 0, 0}},
      {SceneBuilder(false)
           .obstacle(Mesh{box_mesh(Vec3(1e-6, 2, 2))}, at(0, 0))
           .add(ball(0.01))
           .build(),
       {-100, 0.3, 0},
       {90, 0.1, 0.2}},
  };
  for (const Case& c : cases) {
    const CollisionWorld world(c.scene, kPlanningMargin);
    EXPECT_TRUE(world.is_free(kFirst, c.from));
    EXPECT_TRUE(world.is_free(kFirst, c.to));
    EXPECT_FALSE(world.motion_is_free(kFirst, c.from, c.to));
    EXPECT_FALSE(world.motion_is_free(kFirst, c.to, c.from));
    const auto fault = world.first_fault(kFirst, c.from, c.to);
    ASSERT_TRUE(fault.has_value());
    EXPECT_GT(*fault, 0.01);
    EXPECT_LT(*fault, 0.99);
  }
}

TEST(CollisionWorld, RobotsThatSwapPlacesMeetHoweverFast) {
  const CollisionWorld discs(SceneBuilder(true).add(disk(0.001)).add(disk(0.001)).build(), 0);
  const auto at_once = contact(discs, {-1000, 0}, {1000, 0}, {1000, 0}, {-1000, 0});
  ASSERT_TRUE(at_once.has_value());
  EXPECT_NEAR(*at_once, 0.5, 1e-5);
  const auto needles = SceneBuilder(true)
                           .add(footprint(rectangle(0.5, 0.001)))
                           .add(footprint(rectangle(0.5, 0.001)))
                           .build();
  const CollisionWorld world(needles, kPlanningMargin);
  EXPECT_TRUE(
      contact(world, {-10, 0, kPi / 2}, {10, 0, kPi / 2}, {10, 0.3, kPi / 2}, {-10, 0.3, kPi / 2}));
  EXPECT_FALSE(contact(world, {-10, 0, kPi / 2}, {10, 0, kPi / 2}, {10, 0.51, kPi / 2},
                       {-10, 0.51, kPi / 2}));
}

// ---- Contact, clearance, margin ----

TEST(CollisionWorld, TouchingIsAContactAtClearanceZero) {
  const CollisionWorld world(SceneBuilder(true).add(disk(0.5)).add(disk(0.5)).build(),
                             kProofMargin);
  EXPECT_FALSE(world.are_clear(kFirst, Configuration{0, 0}, kSecond, Configuration{1, 0}));
  EXPECT_TRUE(world.are_clear(kFirst, Configuration{0, 0}, kSecond, Configuration{1 + 1e-8, 0}));
}

TEST(CollisionWorld, ClearanceIsKeptFromObstaclesAndRobotsNotFromBoundsOrItself) {
  const auto scene = SceneBuilder(true)
                         .clearance(0.1)
                         .bounds({-2, -2, 0}, {2, 2, 0})
                         .obstacle(Box{Vec3(0.2, 4, 1)}, at(0, 0))
                         .add(disk(0.5))
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  EXPECT_DOUBLE_EQ(world.required_separation(), 0.1 + kPlanningMargin);
  EXPECT_FALSE(world.is_free(kFirst, Configuration{0.69999, 0}));
  EXPECT_TRUE(world.is_free(kFirst, Configuration{0.70001, 0}));
  EXPECT_TRUE(world.is_free(kFirst, Configuration{1.5, 1.5}));  // in the corner, touching
  EXPECT_FALSE(world.is_free(kFirst, Configuration{1.5 + 1e-8, 0}));
  EXPECT_TRUE(world.motion_is_free(kFirst, Configuration{1.5, -1.5}, Configuration{1.5, 1.5}));
}

TEST(CollisionWorld, BodiesMaySlideAlongTheBounds) {
  const auto scene =
      SceneBuilder(true).bounds({-2, -2, 0}, {2, 2, 0}).add(footprint(rectangle(1, 0.5))).build();
  const CollisionWorld world(scene, kPlanningMargin);
  EXPECT_TRUE(world.motion_is_free(kFirst, Configuration{-1, 1.75, 0}, Configuration{1, 1.75, 0}));
  // Turning needs the corners' room.
  EXPECT_FALSE(
      world.motion_is_free(kFirst, Configuration{0, 1.75, 0}, Configuration{0, 1.75, kPi}));
  EXPECT_TRUE(world.motion_is_free(kFirst, Configuration{0, 1.4, 0}, Configuration{0, 1.4, kPi}));
}

TEST(CollisionWorld, PartingBodiesAreFreeThoughTheyStartClose) {
  const auto scene =
      SceneBuilder(true).add(footprint(rectangle(1, 1))).add(footprint(rectangle(1, 1))).build();
  const CollisionWorld world(scene, kPlanningMargin);
  const double close = 1 + 2 * kPlanningMargin;
  EXPECT_FALSE(contact(world, {0, 0, 0}, {-1, 0, 0}, {close, 0, 0}, {close + 1, 0, 0}));
  // Side by side, and one turning away about its far corner.
  EXPECT_FALSE(contact(world, {0, 0, 0}, {0, 3, 0}, {close, 0, 0}, {close, -3, 0}));
}

TEST(CollisionWorld, RestingRobotsAreEitherClearOrInContactAtOnce) {
  const auto scene =
      SceneBuilder(true).add(planar_arm(), at(-1, 0)).add(planar_arm(), at(1, 0)).build();
  const CollisionWorld world(scene, kPlanningMargin);
  const Configuration up{kPi / 2, 0, 0};
  const Configuration right{0, 0, 0};
  const Configuration moved{kPi / 2 - 0.3, 0, 0};
  EXPECT_FALSE(contact(world, up, up, up, up));
  EXPECT_EQ(contact(world, right, right, up, up), 0.0);
  EXPECT_EQ(contact(world, right, right, up, moved), 0.0);
}

// ---- Limits ----

TEST(CollisionWorld, JointLimitsHoldAndSayWhereTheyEnd) {
  const CollisionWorld world(SceneBuilder(true).add(planar_arm()).build(), kPlanningMargin);
  const Configuration inside{3.1, 0, 0};
  const Configuration outside{3.2, 0, 0};
  EXPECT_TRUE(world.is_free(kFirst, inside));
  EXPECT_FALSE(world.is_free(kFirst, outside));
  EXPECT_FALSE(world.motion_is_free(kFirst, inside, outside));
  EXPECT_NEAR(world.first_fault(kFirst, Configuration{3.0, 0, 0}, outside).value(), 0.5, 1e-6);
  const auto fault = world.fault(kFirst, outside);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->kind, Fault::Kind::kLimit);
  EXPECT_EQ(fault->body, "q1");
  EXPECT_NEAR(fault->gap, -0.1, 1e-12);
}

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

// ---- Size, threads ----

TEST(CollisionWorld, AnswersTheSameFromManyThreads) {
  const auto scene = SceneBuilder(false)
                         .add(six_joint_arm(), at(-0.25, 0, 0))
                         .add(six_joint_arm(), at(0.25, 0, 0))
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  Random random(8);
  std::vector<std::array<Configuration, 4>> motions;
  for (int k = 0; k < 100; ++k) {
    auto& m = motions.emplace_back();
    for (auto& q : m) q = random_configuration(*scene->robots[0].model, random, 1);
  }
  const auto answers = [&] {
    std::vector<std::optional<double>> result;
    for (const auto& m : motions) result.push_back(contact(world, m[0], m[1], m[2], m[3]));
    return result;
  };
  const auto expected = answers();
  const std::uint64_t queries = world.distance_queries();
  EXPECT_GT(queries, 0U);
  std::vector<std::vector<std::optional<double>>> found(4);
  std::vector<std::thread> threads;
  for (auto& mine : found) threads.emplace_back([&] { mine = answers(); });
  for (auto& thread : threads) thread.join();
  for (const auto& mine : found) EXPECT_EQ(mine, expected);
  EXPECT_EQ(world.distance_queries(), 5 * queries);
}

TEST(CollisionWorld, TakesLargeMapsInItsStride) {
  SceneBuilder builder(true);
  builder.bounds({0, 0, 0}, {200, 200, 0});
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 100; ++y) {
      builder.obstacle(Box{Vec3(1, 1, 1)}, at(2 * x + 0.5, 2 * y + 0.5));
    }
  }
  const CollisionWorld world(builder.add(disk(0.45)).build(), kPlanningMargin);
  EXPECT_TRUE(world.motion_is_free(kFirst, Configuration{1.5, 1.5}, Configuration{199.5, 1.5}));
  EXPECT_FALSE(world.motion_is_free(kFirst, Configuration{1.5, 1.5}, Configuration{199.5, 1.7}));
  EXPECT_NEAR(world.obstacle_distance(kFirst, Configuration{101.5, 100.5}, 1), 0.05, 1e-9);
}

}  // namespace
}  // namespace accord
