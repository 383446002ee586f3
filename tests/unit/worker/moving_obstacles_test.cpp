#include "worker/moving_obstacles.h"

#include <gtest/gtest.h>

#include "common/geometry/tolerances.h"
#include "common/planning/conflict.h"
#include "common/planning/random.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

constexpr RobotId kMe{0}, kOther{1};
constexpr double kForever = std::numeric_limits<double>::infinity();

TEST(MovingObstacles, LetADiscRestUntilAnotherComesAndAfterItHasPassed) {
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20)
                         .disk(0.5, {0, 0}, {0, 0})
                         .disk(0.5, {-10, 0}, {10, 0})
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  MovingObstacles obstacles(world, kMe, 0);
  obstacles.add(kOther, testing::path({{0, {-10, 0}}, {20, {10, 0}}}), kForever);
  std::vector<Interval> safe;
  obstacles.safe_intervals(Configuration{0, 0}, 0, std::nullopt, safe);
  ASSERT_EQ(safe.size(), 2u);
  EXPECT_NEAR(safe[0].hi, 9, 2e-3);
  EXPECT_NEAR(safe[1].lo, 11, 2e-3);
  EXPECT_EQ(safe[1].hi, kForever);
}

TEST(MovingObstacles, CountTheDistancesOfDiscsToo) {
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20)
                         .disk(0.5, {0, 0}, {0, 0})
                         .disk(0.5, {-10, 0}, {10, 0})
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  {
    MovingObstacles obstacles(world, kMe, 0);
    obstacles.add(kOther, testing::path({{0, {-10, 0}}, {20, {10, 0}}}), kForever);
    std::vector<Interval> safe;
    obstacles.safe_intervals(Configuration{0, 0}, 0, std::nullopt, safe);
    EXPECT_EQ(obstacles.checks(), 0u);
  }
  EXPECT_EQ(world.distance_queries(), 1u) << "as it passes; where it parks it is out of reach";
}

TEST(MovingObstacles, AllowNoRestWhereAnotherRobotParks) {
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20)
                         .disk(0.5, {0, 0}, {0, 0})
                         .disk(0.5, {5, 0}, {0.5, 0})
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  MovingObstacles obstacles(world, kMe, 0);
  obstacles.add(kOther, testing::path({{0, {5, 0}}, {4.5, {0.5, 0}}}), kForever);
  std::vector<Interval> safe;
  obstacles.safe_intervals(Configuration{0, 0}, 0, std::nullopt, safe);
  ASSERT_EQ(safe.size(), 1u);
  EXPECT_NEAR(safe[0].hi, 4, 2e-3);
}

// The same questions for discs and for carts, whose answers come from different code.
class EarliestDeparture : public ::testing::TestWithParam<bool> {
 protected:
  static std::shared_ptr<const RobotModel> model() {
    return GetParam() ? testing::disk_model(0.5) : testing::cart_model(0.8, 0.8);
  }
  static Configuration at(double x, double y) {
    return GetParam() ? Configuration{x, y} : Configuration{x, y, 0};
  }
};

TEST_P(EarliestDeparture, IsAtOnceWhenTheWayIsClearAndLaterWhenItIsNot) {
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20)
                         .robot(model(), at(0, -5), at(0, 5))
                         .robot(model(), at(-5, 0), at(5, 0))
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  MovingObstacles obstacles(world, kMe, 0);
  const Trajectory crossing = testing::path({{0, at(-5, 0)}, {10, at(5, 0)}});
  obstacles.add(kOther, crossing, kForever);
  EXPECT_EQ(obstacles.earliest_departure(at(0, -5), at(0, 5), 10, 50, 60), 50.0);
  const auto late = obstacles.earliest_departure(at(0, -5), at(0, 5), 10, 0, 60);
  ASSERT_TRUE(late);
  EXPECT_GT(*late, 0.8);
  EXPECT_LT(*late, 2.6);
  const Trajectory mine = testing::path({{*late, at(0, -5)}, {*late + 10, at(0, 5)}});
  EXPECT_FALSE(earliest_contact(world, kMe, mine, kOther, crossing, *late, 100));
  EXPECT_TRUE(obstacles.motion_is_clear(at(0, -5), at(0, 5), *late, 10));
  EXPECT_FALSE(obstacles.motion_is_clear(at(0, -5), at(0, 5), 0, 10));
  EXPECT_FALSE(obstacles.earliest_departure(at(0, -5), at(0, 5), 10, 0, 0.5));
}

// However late: once, the search for a departure went on until the times were too large to tell a
// departure from its arrival, and found that one clear.
TEST_P(EarliestDeparture, NeverComesWhenAnotherRobotParksInTheWay) {
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20)
                         .robot(model(), at(0, -5), at(0, 5))
                         .robot(model(), at(-5, 0), at(0, 0))
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  MovingObstacles obstacles(world, kMe, 0);
  obstacles.add(kOther, testing::path({{0, at(-5, 0)}, {5, at(0, 0)}}), kForever);
  EXPECT_FALSE(obstacles.earliest_departure(at(0, -5), at(0, 5), 10, 0, kForever));
  EXPECT_FALSE(obstacles.earliest_departure(at(0, -5), at(0, 5), 10, 20, kForever));
}

INSTANTIATE_TEST_SUITE_P(Kinds, EarliestDeparture, ::testing::Values(true, false));

TEST(MovingObstacles, EveryRestAndDepartureTheyAllowIsFreeOfConflicts) {
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20)
                         .disk(0.5, {0, 0}, {0, 0})
                         .disk(0.7, {5, 0}, {0.5, 0})
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  RandomStream random(7);
  const auto place = [&] { return Configuration{random.uniform(-3, 3), random.uniform(-3, 3)}; };
  int departures = 0;
  for (int round = 0; round < 300; ++round) {
    Trajectory other(2);
    double t = 0;
    for (int i = 0; i < 5; ++i, t += random.uniform(0.5, 3)) other.append(t, place());
    MovingObstacles obstacles(world, kMe, 0);
    obstacles.add(kOther, other, kForever);
    const Configuration a = place(), b = place();
    std::vector<Interval> safe;
    obstacles.safe_intervals(a, 0, std::nullopt, safe);
    for (const Interval& interval : safe) {
      const Trajectory rest = testing::path({{interval.lo, a}});
      EXPECT_FALSE(earliest_contact(world, kMe, rest, kOther, other, interval.lo + 1e-9,
                                    interval.hi - 1e-9));
    }
    const double duration = random.uniform(0.5, 4);
    const auto departure = obstacles.earliest_departure(a, b, duration, 0, 20);
    if (!departure) continue;
    ++departures;
    const Trajectory mine = testing::path({{*departure, a}, {*departure + duration, b}});
    EXPECT_FALSE(
        earliest_contact(world, kMe, mine, kOther, other, *departure, *departure + duration));
    // And no earlier departure on a fine grid is free: it is the earliest.
    for (double early = 0; early < *departure - 3e-3; early += 0.02) {
      EXPECT_FALSE(obstacles.motion_is_clear(a, b, early, duration)) << early;
    }
  }
  EXPECT_GT(departures, 100);
}

}  // namespace
}  // namespace accord
