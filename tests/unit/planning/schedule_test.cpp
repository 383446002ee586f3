#include "common/planning/schedule.h"

#include <gtest/gtest.h>

#include "common/planning/splice.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

using testing::path;

constexpr RobotId kFirst{0}, kSecond{1};

class ScheduleTest : public ::testing::Test {
 protected:
  ScheduleTest()
      : scene_(testing::SceneBuilder(-20, -20, 20, 20)
                   .disk(0.5, {0, 0}, {10, 0})
                   .disk(0.5, {10, 0}, {0, 0})
                   .build()),
        schedule_(scene_) {
    schedule_.set_initial(kFirst, path({{0, {0, 0}}, {10, {10, 0}}}), "straight");
    schedule_.set_initial(kSecond, path({{0, {10, 0}}, {10, {0, 0}}}), "straight");
  }

  // Both robots between 3 s and 7 s.
  Subproblem window() const {
    Subproblem subproblem;
    subproblem.from = 3;
    subproblem.to = 7;
    for (const RobotId robot : {kFirst, kSecond}) {
      Task task;
      task.robot = robot;
      task.version = schedule_.version(robot);
      task.start = schedule_.path(robot).at(3);
      task.to = 7;
      task.goal = schedule_.path(robot).at(7);
      subproblem.tasks.push_back(task);
    }
    return subproblem;
  }

  // The first goes round and takes 2 s more; the second is not delayed.
  static Resolution detour() {
    Resolution resolution;
    resolution.solved = true;
    resolution.solver = "test";
    resolution.end = 9;
    resolution.paths = {path({{3, {3, 0}}, {6, {5, 2}}, {9, {7, 0}}}),
                        path({{3, {7, 0}}, {7, {3, 0}}})};
    return resolution;
  }

  std::shared_ptr<const Scene> scene_;
  Schedule schedule_;
};

TEST_F(ScheduleTest, SplicesLocalPathsInAndGoesOnAlongTheTailsAtOnce) {
  ASSERT_TRUE(schedule_.commit(window(), detour()));
  EXPECT_EQ(schedule_.path(kFirst),
            path({{0, {0, 0}}, {3, {3, 0}}, {6, {5, 2}}, {9, {7, 0}}, {12, {10, 0}}}));
  EXPECT_EQ(schedule_.path(kSecond), path({{0, {10, 0}}, {3, {7, 0}}, {7, {3, 0}}, {10, {0, 0}}}));
}

TEST_F(ScheduleTest, KnowsWhichSubproblemEachStretchCameOfThoughItIsDelayed) {
  ASSERT_TRUE(schedule_.commit(window(), detour(), 7));
  const auto& coupling = schedule_.coupling(kFirst);
  ASSERT_EQ(coupling.size(), 3U);
  EXPECT_EQ(coupling[0].subproblem, 0U);
  EXPECT_EQ(coupling[1].subproblem, 7U);
  EXPECT_EQ(coupling[2].subproblem, 0U);
  schedule_.set_initial(kSecond, schedule_.path(kSecond), "straight", 2);
  EXPECT_EQ(schedule_.coupling(kSecond).front().subproblem, 2U);
}

TEST_F(ScheduleTest, KeepsTheCouplingTimelineWithoutGaps) {
  ASSERT_TRUE(schedule_.commit(window(), detour()));
  const auto& coupling = schedule_.coupling(kFirst);
  ASSERT_EQ(coupling.size(), 3u);
  EXPECT_EQ(coupling[0].to, 3);
  EXPECT_EQ(coupling[1].from, 3);
  EXPECT_EQ(coupling[1].to, 9);
  EXPECT_EQ(coupling[1].robots, (std::vector<RobotId>{kFirst, kSecond}));
  EXPECT_EQ(coupling[1].solver, "test");
  EXPECT_EQ(coupling[2].from, 9);
  EXPECT_EQ(coupling[2].to, 12);
  EXPECT_EQ(coupling[2].solver, "straight");
}

TEST_F(ScheduleTest, CountsParkingAsPartOfHowARobotGotThere) {
  Subproblem late;
  late.from = 12;  // both have parked since 10 s
  late.to = 14;
  for (const RobotId robot : {kFirst, kSecond}) {
    Task task;
    task.robot = robot;
    task.version = 1;
    task.start = task.goal = schedule_.path(robot).at(12);
    task.to = 14;
    late.tasks.push_back(task);
  }
  Resolution aside;
  aside.solved = true;
  aside.solver = "aside";
  aside.end = 14;
  aside.paths = {path({{12, {10, 0}}, {13, {10, 1}}, {14, {10, 0}}}),
                 path({{12, {0, 0}}, {13, {0, 1}}, {14, {0, 0}}})};
  ASSERT_TRUE(schedule_.commit(late, aside));
  const auto& coupling = schedule_.coupling(kFirst);
  ASSERT_EQ(coupling.size(), 2u);
  EXPECT_EQ(coupling[0].from, 0);
  EXPECT_EQ(coupling[0].to, 12);
  EXPECT_EQ(coupling[1].from, 12);
  EXPECT_EQ(coupling[1].to, 14);
}

TEST(ScheduleOfParkedRobots, HasATimelineFromTheStartWhenTheyAreMoved) {
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20).disk(0.5, {0, 0}, {0, 0}).build();
  Schedule schedule(scene);
  schedule.set_initial(kFirst, path({{0, {0, 0}}}), "straight");
  Subproblem window;
  window.from = 1;
  window.to = 1;
  Task task;
  task.robot = kFirst;
  task.version = 1;
  task.start = task.goal = {0, 0};
  task.to = 1;
  window.tasks.push_back(task);
  Resolution aside;
  aside.solved = true;
  aside.solver = "aside";
  aside.end = 3;
  aside.paths = {path({{1, {0, 0}}, {2, {0, 1}}, {3, {0, 0}}})};
  ASSERT_TRUE(schedule.commit(window, aside));
  const auto& coupling = schedule.coupling(kFirst);
  ASSERT_EQ(coupling.size(), 2u);
  EXPECT_EQ(coupling[0].from, 0);
  EXPECT_EQ(coupling[0].to, 1);
  EXPECT_EQ(coupling[0].solver, "straight");
  EXPECT_EQ(coupling[1].to, 3);
}

TEST_F(ScheduleTest, RefusesAResolutionOfOlderVersions) {
  const Subproblem stale = window();
  ASSERT_TRUE(schedule_.commit(stale, detour()));
  const Trajectory before = schedule_.path(kFirst);
  EXPECT_FALSE(schedule_.commit(stale, detour()));
  EXPECT_EQ(schedule_.path(kFirst), before);
}

TEST_F(ScheduleTest, RefusesPathsThatDoNotFitTheWindow) {
  Resolution elsewhere = detour();
  elsewhere.paths[0] = path({{3, {3, 1}}, {9, {7, 0}}});
  EXPECT_FALSE(schedule_.commit(window(), elsewhere));
  Resolution late = detour();
  late.end = 8;
  EXPECT_FALSE(schedule_.commit(window(), late));
  Resolution short_of_goal = detour();
  short_of_goal.paths[1] = path({{3, {7, 0}}, {7, {4, 0}}});
  EXPECT_FALSE(schedule_.commit(window(), short_of_goal));
#ifdef NDEBUG  // with assertions such a path cannot be made
  Resolution standing = detour();
  standing.paths[1] = path({{3, {7, 0}}, {3, {7, 0}}, {7, {3, 0}}});
  EXPECT_FALSE(schedule_.commit(window(), standing));
#endif
  Resolution missing = detour();
  missing.paths.pop_back();
  EXPECT_FALSE(schedule_.commit(window(), missing));
  EXPECT_EQ(schedule_.version(kFirst), 1u);
}

TEST(AppendTail, KeepsWaypointsApartThatShiftingBringsTogether) {
  constexpr double kHair = 1e-15;  // s: apart near 0, the same near 100
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20).disk(0.5, {0, 0}, {2, 0}).build();
  const Trajectory old =
      path({{0, {0, 0}}, {2e-9, {1, 0}}, {2e-9 + kHair, {1, 0}}, {3e-9, {2, 0}}});
  Trajectory late = path({{0, {0, 0}}, {100, {0, 0}}});
  append_tail(*scene->robot(kFirst).model, old, 0, late);
  ASSERT_EQ(late.size(), 5u);
  for (std::size_t i = 1; i < late.size(); ++i) EXPECT_GT(late.time(i), late.time(i - 1));
  EXPECT_EQ(late.configuration(4)[0], 2);
}

TEST(ScheduleHeadings, GoOnInTheWholeTurnsThatTheLocalPathEndedIn) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20)
                         .robot(testing::cart_model(1, 1), {0, 0, 0}, {10, 0, 0})
                         .build();
  Schedule schedule(scene);
  schedule.set_initial(kFirst, path({{0, {0, 0, 0}}, {10, {10, 0, 0}}}), "straight");
  Subproblem window;
  window.from = 2;
  window.to = 8;
  Task task;
  task.robot = kFirst;
  task.version = 1;
  task.start = {2, 0, 0};
  task.to = 8;
  task.goal = {8, 0, 0};
  window.tasks.push_back(task);
  Resolution spin;
  spin.solved = true;
  spin.end = 8;
  spin.paths = {path({{2, {2, 0, 0}}, {8, {8, 0, kTurn}}})};
  ASSERT_TRUE(schedule.commit(window, spin));
  EXPECT_NEAR(schedule.path(kFirst).at(10)[2], kTurn, 1e-12);
}

}  // namespace
}  // namespace accord
