#include "worker/team.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/geometry/tolerances.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Two discs and a cart, in a room with a box.
class TeamTest : public ::testing::Test {
 protected:
  TeamTest()
      : world_(testing::SceneBuilder(-9, -9, 9, 9)
                   .box(-0.5, 2, 0.5, 9)
                   .disk(0.5, {-4, 0}, {4, 0})
                   .robot(testing::disk_model(0.5, 2), {4, 0}, {-4, 0})
                   .robot(testing::cart_model(1, 0.6), {0, -5, 0}, {0, -5, 3})
                   .build(),
               kPlanningMargin) {}

  Team team(std::vector<RobotId> members) { return {world_, std::move(members), 0}; }

  CollisionWorld world_;
};

TEST_F(TeamTest, IsFreeWhereEachMemberIsAndNoTwoTouch) {
  const Team both = team({{0}, {1}});
  EXPECT_TRUE(both.is_free(Configuration{-4, 0, 4, 0}));
  EXPECT_FALSE(both.is_free(Configuration{-4, 0, -3.5, 0}));  // each other
  EXPECT_FALSE(both.is_free(Configuration{0, 3, 4, 0}));      // the box
}

TEST_F(TeamTest, MovesFreelyOnlyWhereMembersNeverMeetOnTheWay) {
  const Team both = team({{0}, {1}});
  EXPECT_FALSE(both.motion_is_free(Configuration{-4, 0, 4, 0}, Configuration{4, 0, -4, 0}));
  EXPECT_TRUE(both.motion_is_free(Configuration{-4, 0, 4, 0}, Configuration{-4, 5, 4, 5}));
  EXPECT_FALSE(both.motion_is_free(Configuration{-4, 5, 4, 0}, Configuration{4, 5, 4, -5}));
}

TEST_F(TeamTest, IsAsSlowAsItsSlowestMember) {
  const Team both = team({{0}, {1}});
  EXPECT_NEAR(both.duration(Configuration{-4, 0, 4, 0}, Configuration{-1, 0, 4, 0}), 3, 1e-5);
  EXPECT_NEAR(both.duration(Configuration{-4, 0, 4, 0}, Configuration{-4, 0, 1, 0}), 1.5, 1e-5);
}

TEST_F(TeamTest, MeasuresHeadingsTheShortWayRound) {
  const Team cart = team({{2}});
  const Configuration a{0, -5, 3}, b{0, -5, -3};
  EXPECT_LT(cart.squared_distance(a, b), cart.squared_distance(a, Configuration{0, -5, 2}));
  Configuration near(3);
  cart.nearest_representation(a, b, near);
  EXPECT_NEAR(near[2], 2 * 3.14159265358979 - 3, 1e-9);
}

TEST_F(TeamTest, WaitsSafelyOnlyWhenNoMemberIsPassed) {
  Team both = team({{0}, {1}});
  both.avoid({2}, testing::path({{0, {-8, 0, 0}}, {16, {8, 0, 0}}}));
  std::vector<Interval> safe;
  both.safe_intervals(Configuration{-4, 0, 4, 0}, 0, safe);
  ASSERT_EQ(safe.size(), 3u);  // before the cart, between the two, after
  EXPECT_NEAR(safe[0].hi, 3, 0.2);
  EXPECT_NEAR(safe[1].lo, 5, 0.3);
  EXPECT_NEAR(safe[1].hi, 11, 0.3);
  EXPECT_EQ(safe[2].hi, kInfinity);
}

TEST_F(TeamTest, DepartsWhenAllMembersCan) {
  Team both = team({{0}, {1}});
  both.avoid({2}, testing::path({{0, {-8, 0, 0}}, {16, {8, 0, 0}}}), kInfinity);
  const Configuration from{-4, 2, 4, 2}, to{-4, -2, 4, -2};
  const auto departure = both.earliest_departure(from, to, 4, 1.5, 100);
  ASSERT_TRUE(departure);
  EXPECT_TRUE(both.motion_is_clear(from, to, *departure, 4));
  EXPECT_GT(*departure, 3.5);  // the first is passed at t = 4
  EXPECT_LT(*departure, 5);    // and the second not before t = 12
  EXPECT_FALSE(both.motion_is_clear(from, to, 2, 4));
  EXPECT_FALSE(both.motion_is_clear(from, to, 10, 4));
}

}  // namespace
}  // namespace accord
