#include "worker/path_planner.h"

#include <gtest/gtest.h>

#include "common/geometry/tolerances.h"
#include "common/planning/region.h"
#include "tests/support/scenes.h"
#include "worker/free_samples.h"

namespace accord {
namespace {

const std::atomic<bool> kGoOn{false};

Subproblem alone(const Scene& scene) {
  const Robot& robot = scene.robot({0});
  Subproblem out;
  out.whole = true;
  out.tasks.push_back({{0}, 0, robot.start, 0, robot.goal, whole_region(scene, {0}), {}, {}, -1});
  return out;
}

Resolution plan_first(const testing::SceneBuilder& builder, const std::atomic<bool>& stop = kGoOn) {
  const auto scene = builder.build();
  const CollisionWorld world(scene, kPlanningMargin);
  const Resolution found = plan_alone(Workspace(world), alone(*scene), stop);
  for (const Trajectory& path : found.paths) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      EXPECT_TRUE(world.motion_is_free({0}, path.configuration(i - 1), path.configuration(i)));
    }
    EXPECT_EQ(path.start_time(), 0);
    EXPECT_EQ(path.end_time(), found.end);
  }
  return found;
}

TEST(PathPlanner, GoesStraightAtFullSpeedWhereNothingIsInTheWay) {
  const Resolution found =
      plan_first(testing::SceneBuilder(-5, -5, 5, 5).disk(0.5, {-4, 0}, {4, 0}));
  ASSERT_TRUE(found.solved);
  EXPECT_EQ(found.solver, kStraight);
  EXPECT_NEAR(found.end, 8, 1e-5);
  EXPECT_EQ(found.roadmap_level, -1);
}

TEST(PathPlanner, GoesRoundAnObstacleOnAWayHardlyLongerThanTheShortest) {
  const Resolution found =
      plan_first(testing::SceneBuilder(-5, -5, 5, 5).box(-1, -2, 1, 2).disk(0.5, {-4, 0}, {4, 0}));
  ASSERT_TRUE(found.solved);
  EXPECT_EQ(found.solver, kRoadmap);
  // Tangents to the corners' circles of 0.5 m, and along the box's side.
  EXPECT_GT(found.end, 9.3);
  EXPECT_LT(found.end, 9.3 * 1.1);
}

TEST(PathPlanner, TurnsACartTheShorterWayRound) {
  const Resolution found =
      plan_first(testing::SceneBuilder(-5, -5, 5, 5)
                     .robot(testing::cart_model(1, 0.6), {0, 0, 3}, {0, 0, -3}));
  ASSERT_TRUE(found.solved);
  EXPECT_NEAR(found.end, 2 * (3.14159265 - 3), 1e-4);
}

TEST(PathPlanner, FindsNoWayIntoAClosedRoom) {
  const Resolution found = plan_first(
      testing::SceneBuilder(-5, -5, 5, 5).box(-0.1, -5, 0.1, 5).disk(0.5, {-4, 0}, {4, 0}));
  EXPECT_FALSE(found.solved);
  EXPECT_TRUE(found.paths.empty());
}

TEST(PathPlanner, EndsAtOnceWhenToldToStop) {
  const std::atomic<bool> stop{true};
  const Resolution found = plan_first(
      testing::SceneBuilder(-5, -5, 5, 5).box(-1, -2, 1, 2).disk(0.5, {-4, 0}, {4, 0}), stop);
  EXPECT_FALSE(found.solved);
}

TEST(FreeSamples, AreFreeManyAndReachIntoNarrowDoors) {
  const CollisionWorld world(testing::SceneBuilder(-5, -5, 5, 5)
                                 .box(-0.5, -5, 0.5, -0.7)
                                 .box(-0.5, 0.7, 0.5, 5)
                                 .disk(0.5, {-4, 0}, {4, 0})
                                 .build(),
                             kPlanningMargin);
  const auto samples = free_samples(world, {0}, 800);
  EXPECT_EQ(samples.size(), 800u);
  std::size_t in_the_door = 0;
  for (const Configuration& q : samples) {
    EXPECT_TRUE(world.is_free({0}, q));
    if (std::abs(q[0]) < 0.5 && std::abs(q[1]) < 0.2) ++in_the_door;
  }
  EXPECT_GE(in_the_door, 1u);
  EXPECT_EQ(samples, free_samples(world, {0}, 800));
}

}  // namespace
}  // namespace accord
