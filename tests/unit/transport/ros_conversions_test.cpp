#include "common/transport/dds/ros/ros_conversions.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/scenes.h"

namespace accord::dds {
namespace {

TEST(RosJointTrajectory, HasAnArmsJointsAndTimes) {
  const auto scene = testing::SceneBuilder(-3, -3, 3, 3)
                         .robot(testing::planar_arm_model({1, 0.8}), {0, 0}, {1, -1})
                         .build();
  const auto path = testing::path({{0, {0, 0}}, {1.25, {0.5, -0.25}}, {3, {1, -1}}});
  const auto message = to_joint_trajectory(path, scene->robots[0], "cell");
  EXPECT_EQ(message.header().frame_id(), "cell");
  const auto& dofs = scene->robots[0].model->dofs;
  EXPECT_EQ(message.joint_names(), (std::vector<std::string>{dofs[0].name, dofs[1].name}));
  ASSERT_EQ(message.points().size(), 3U);
  EXPECT_EQ(message.points()[1].positions(), (std::vector<double>{0.5, -0.25}));
  EXPECT_TRUE(message.points()[1].velocities().empty());
  EXPECT_EQ(message.points()[1].time_from_start().sec(), 1);
  EXPECT_EQ(message.points()[1].time_from_start().nanosec(), 250'000'000U);
}

// What is a whole second but for rounding is one: nanoseconds stay below a second's.
TEST(RosJointTrajectory, RoundsTimesToNanoseconds) {
  const auto scene =
      testing::SceneBuilder(-3, -3, 3, 3).robot(testing::planar_arm_model({1}), {0}, {1}).build();
  const auto path = testing::path({{0, {0}}, {2 - 1e-12, {0.5}}, {1e12, {1}}});
  const auto message = to_joint_trajectory(path, scene->robots[0], "map");
  EXPECT_EQ(message.points()[1].time_from_start().sec(), 2);
  EXPECT_EQ(message.points()[1].time_from_start().nanosec(), 0U);
  EXPECT_EQ(message.points()[2].time_from_start().sec(), std::numeric_limits<std::int32_t>::max());
}

TEST(RosPath, HasAMobileRobotsPlacesInTheScene) {
  Pose base = Pose::Identity();
  base.translation() = Vec3(10, 0, 0);
  base.linear() = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()).toRotationMatrix();
  const auto scene = testing::SceneBuilder(-30, -30, 30, 30)
                         .disk(0.5, {0, 0}, {1, 2})
                         .robot(testing::cart_model(1, 0.6), {0, 0, 0}, {1, 2, 1}, base)
                         .build();
  const auto disc = to_path(testing::path({{0, {0, 0}}, {1.5, {1, 2}}}), scene->robots[0], "map");
  ASSERT_EQ(disc.poses().size(), 2U);
  EXPECT_EQ(disc.poses()[1].header().stamp().sec(), 1);
  EXPECT_EQ(disc.poses()[1].header().stamp().nanosec(), 500'000'000U);
  EXPECT_EQ(disc.poses()[1].header().frame_id(), "map");
  EXPECT_EQ(disc.poses()[1].pose().position().x(), 1);
  EXPECT_EQ(disc.poses()[1].pose().position().y(), 2);
  EXPECT_EQ(disc.poses()[1].pose().orientation().w(), 1);

  const auto cart = to_path(testing::path({{0, {0, 0, 0}}, {2, {1, 2, std::numbers::pi / 2}}}),
                            scene->robots[1], "map");
  const auto& pose = cart.poses()[1].pose();
  EXPECT_NEAR(pose.position().x(), 8, 1e-12);
  EXPECT_NEAR(pose.position().y(), 1, 1e-12);
  EXPECT_NEAR(std::abs(pose.orientation().z()), 1, 1e-12) << "half a turn";
  EXPECT_NEAR(pose.orientation().w(), 0, 1e-12);
}

}  // namespace
}  // namespace accord::dds
