// CollisionWorld on motions, case by case; tests/contract holds it against sampling at large.
#include "common/geometry/collision_world.h"

#include <gtest/gtest.h>

#include <numbers>
#include <thread>

#include "common/geometry/tolerances.h"
#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using namespace test_scenes;

constexpr RobotId kFirst{0};
constexpr RobotId kSecond{1};
constexpr double kPi = std::numbers::pi;

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
