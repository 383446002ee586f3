#include "common/planning/conflict.h"

#include <gtest/gtest.h>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

using testing::path;

constexpr RobotId kFirst{0}, kSecond{1};
constexpr double kForever = std::numeric_limits<double>::infinity();

class EarliestContact : public ::testing::Test {
 protected:
  std::optional<double> between(const Trajectory& a, const Trajectory& b, double from = 0,
                                double until = kForever) const {
    return earliest_contact(world_, kFirst, a, kSecond, b, from, until);
  }

  CollisionWorld world_{testing::SceneBuilder(-50, -50, 50, 50)
                            .disk(0.5, {0, 0}, {0, 0})
                            .disk(0.5, {5, 0}, {5, 0})
                            .build(),
                        kPlanningMargin};
};

TEST_F(EarliestContact, IsFoundBetweenTimestepsWhereSamplingWouldMissIt) {
  // Two discs cross at right angles at 400 m/s: no tenth of a second sees them overlap.
  const Trajectory a = path({{0, {-20, 0}}, {0.1, {20, 0}}});
  const Trajectory b = path({{0, {0, -20}}, {0.1, {0, 20}}});
  const auto time = between(a, b);
  ASSERT_TRUE(time);
  EXPECT_NEAR(*time, 0.05 - std::sqrt(0.5) / 400, 1e-5);
}

TEST_F(EarliestContact, CountsAStretchOnWhichBothMoveLinearlyAsOneDistance) {
  const Trajectory a = path({{0, {0, 0}}, {1, {1, 0}}, {3, {0, 0}}});
  const Trajectory b = path({{0, {0, 5}}, {2, {5, 5}}});
  EXPECT_FALSE(between(a, b));
  EXPECT_EQ(world_.distance_queries(), 4u) << "until 1 s, 2 s, 3 s, and parked";
}

TEST_F(EarliestContact, SpansWaypointsOfBothPathsAtDifferentTimes) {
  const Trajectory a = path({{0, {-10, 0}}, {3, {-10, 0}}, {8, {0, 0}}});
  const Trajectory b = path({{0, {10, 0}}, {5, {10, 0}}, {6, {2, 0}}, {30, {0, 0}}});
  const auto time = between(a, b);
  ASSERT_TRUE(time);
  EXPECT_NEAR(*time, 18, 1e-3);
}

TEST_F(EarliestContact, SeesARobotThatIsRunOverAfterItHasParked) {
  const Trajectory parked = path({{0, {1, 1}}, {1, {0, 0}}});
  const Trajectory late = path({{0, {30, 0}}, {40, {30, 0}}, {70, {0, 0}}});
  const auto time = between(parked, late);
  ASSERT_TRUE(time);
  EXPECT_NEAR(*time, 69, 1e-4);
}

TEST_F(EarliestContact, LooksOnlyInsideTheTimeAskedFor) {
  const Trajectory a = path({{0, {-10, 0}}, {20, {10, 0}}});
  const Trajectory b = path({{0, {0, 0}}});
  EXPECT_NEAR(*between(a, b), 9, 1e-4);
  EXPECT_FALSE(between(a, b, 0, 8.9));
  EXPECT_FALSE(between(a, b, 11.1));
  EXPECT_EQ(*between(a, b, 10), 10);
}

TEST_F(EarliestContact, IsNoneForRobotsThatPassWithRoomToSpare) {
  EXPECT_FALSE(
      between(path({{0, {-10, 0}}, {20, {10, 0}}}), path({{0, {10, 1.01}}, {20, {-10, 1.01}}})));
  EXPECT_TRUE(
      between(path({{0, {-10, 0}}, {20, {10, 0}}}), path({{0, {10, 0.99}}, {20, {-10, 0.99}}})));
}

}  // namespace
}  // namespace accord
