#include "worker/safe_interval_search.h"

#include <gtest/gtest.h>

#include "common/geometry/tolerances.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

constexpr RobotId kMe{0}, kOther{1};
constexpr std::uint64_t kChecks = 1000;

// A corridor along x with a side pocket at x = 0; another disc comes the other way.
class SafeIntervalSearch : public ::testing::Test {
 protected:
  SafeIntervalSearch()
      : scene_(testing::SceneBuilder(-10, -1, 10, 3)
                   .box(-10, 0.7, -1, 3)
                   .box(1, 0.7, 10, 3)
                   .disk(0.5, {-5, 0}, {5, 0})
                   .disk(0.5, {5, 0}, {-5, 0})
                   .build()),
        world_(scene_, kPlanningMargin),
        team_(world_, {kMe}, 0),
        roadmap_(team_) {
    start_ = roadmap_.add(team_, Configuration{-5, 0});
    goal_ = roadmap_.add(team_, Configuration{5, 0});
    const auto mouth = roadmap_.add(team_, Configuration{0, 0});
    const auto pocket = roadmap_.add(team_, Configuration{0, 2});
    roadmap_.connect(team_, start_, mouth);
    roadmap_.connect(team_, mouth, pocket);
    roadmap_.connect(team_, mouth, goal_);
  }

  std::optional<Trajectory> search() {
    std::uint64_t expanded = 0;
    return safe_interval_search(team_, roadmap_, {start_, goal_, 0, 0, 1000, kChecks}, stop_,
                                expanded);
  }

  std::shared_ptr<const Scene> scene_;
  CollisionWorld world_;
  Team team_;
  LocalRoadmap roadmap_;
  LocalRoadmap::Node start_ = 0, goal_ = 0;
  std::atomic<bool> stop_{false};
};

TEST_F(SafeIntervalSearch, TakesTheShortestWayWhenNothingMoves) {
  const auto found = search();
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->end_time(), 10, 1e-4);
}

TEST_F(SafeIntervalSearch, StepsAsideForAnotherRobotAndGoesOn) {
  // It halts halfway until this one can have reached the pocket, then goes through.
  team_.avoid(kOther, testing::path({{0, {5, 0}}, {2, {3, 0}}, {6, {3, 0}}, {14, {-5, 0}}}));
  const auto found = search();
  ASSERT_TRUE(found);
  EXPECT_GT(found->end_time(), 14);
  EXPECT_LT(found->end_time(), 20);
}

TEST_F(SafeIntervalSearch, FindsNothingWhenTheOtherNeverLetsItIn) {
  team_.avoid(kOther, testing::path({{0, {5, 0}}, {10, {-5, 0}}}));
  EXPECT_FALSE(search());  // the start itself is run over at the end
}

TEST_F(SafeIntervalSearch, EndsWithoutAWayWhenStopped) {
  stop_ = true;
  EXPECT_FALSE(search());
}

TEST_F(SafeIntervalSearch, WaitsForAGoalThatIsStillToBeCrossed) {
  team_.avoid(kOther, testing::path({{0, {9, 0}}, {30, {9, 0}}, {36, {3, 0}}, {42, {9, 0}}}));
  std::uint64_t expanded = 0;
  const auto found =
      safe_interval_search(team_, roadmap_, {start_, goal_, 0, 38, 1000, kChecks}, stop_, expanded);
  ASSERT_TRUE(found);
  EXPECT_GT(found->end_time(), 38);  // the goal has to be free from 38 s on
}

}  // namespace
}  // namespace accord
