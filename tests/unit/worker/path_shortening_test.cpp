#include "worker/path_shortening.h"

#include <gtest/gtest.h>

#include "common/geometry/tolerances.h"
#include "common/planning/conflict.h"
#include "tests/support/scenes.h"
#include "worker/continuation.h"
#include "worker/uncoupling.h"

namespace accord {
namespace {

const std::atomic<bool> kGoOn{false};

// A disc that has gone (0,0), (0,4), (4,4), (4,0), and one that crosses the straight way at t = 2.
class PathShortening : public ::testing::Test {
 protected:
  explicit PathShortening()
      : world_(testing::SceneBuilder(-6, -6, 6, 6)
                   .disk(0.5, {0, 0}, {4, 0})
                   .disk(0.5, {2, -4}, {2, 4})
                   .build(),
               kPlanningMargin),
        team_(world_, {RobotId{0}}, 0),
        path_(testing::path({{0, {0, 0}}, {4, {0, 4}}, {8, {4, 4}}, {12, {4, 0}}})) {}

  void shorten_path() { shorten(team_, {0, 1, 0, 20, 1000, 10000}, path_, kGoOn, effort_); }

  CollisionWorld world_;
  Team team_;
  Trajectory path_;
  Effort effort_;
};

TEST_F(PathShortening, TakesTheStraightWayWhereNobodyMoves) {
  shorten_path();
  EXPECT_NEAR(path_.end_time(), 4, 1e-3);
}

TEST_F(PathShortening, KeepsClearOfWhoMoves) {
  const Trajectory other = testing::path({{0, {2, -4}}, {8, {2, 4}}});
  team_.avoid({1}, other);
  shorten_path();
  EXPECT_LT(path_.end_time(), 12);
  EXPECT_FALSE(earliest_contact(world_, {0}, path_, {1}, other, 0, 20));
  EXPECT_EQ(path_.configuration(0)[0], 0);
  EXPECT_EQ(path_.configuration(path_.size() - 1)[0], 4);
}

TEST_F(PathShortening, LeavesAPathThatIsAsShortAsItCanBe) {
  path_ = testing::path({{0, {0, 0}}, {4.001, {4, 0}}});
  const Trajectory before = path_;
  shorten_path();
  EXPECT_EQ(path_, before);
}

TEST_F(PathShortening, LeavesThePathWhenToldToStop) {
  const Trajectory before = path_;
  const std::atomic<bool> stop{true};
  shorten(team_, {0, 1, 0, 20, 1000, 10000}, path_, stop, effort_);
  EXPECT_EQ(path_, before);
}

Task task_of(std::uint32_t robot, Configuration start, Configuration goal, double to) {
  Task task;
  task.robot = {robot};
  task.start = std::move(start);
  task.goal = std::move(goal);
  task.to = to;
  return task;
}

// Both discs move as one: the second is as slow as the first, though its way is short.
TEST_F(PathShortening, UncouplingLetsEachRobotMoveAtItsOwnPace) {
  Subproblem subproblem;
  subproblem.horizon = 40;
  subproblem.tasks = {task_of(0, {0, 0}, {4, 0}, 4), task_of(1, {2, -4}, {2, -2}, 2)};
  Resolution joint;
  joint.solved = true;
  joint.end = 4;
  joint.paths = {testing::path({{0, {0, 0}}, {2, {2, 0}}, {4, {4, 0}}}),
                 testing::path({{0, {2, -4}}, {2, {2, -3}}, {4, {2, -2}}})};
  uncouple(world_, subproblem, joint, kGoOn);
  EXPECT_NEAR(joint.paths[0].end_time(), 4, 1e-3);
  EXPECT_NEAR(joint.paths[1].end_time(), 2, 1e-3);
  EXPECT_FALSE(earliest_contact(world_, {0}, joint.paths[0], {1}, joint.paths[1], 0, 40));
}

TEST_F(PathShortening, TailsFollowTheirLocalPathWhenItIsLate) {
  Task task = task_of(0, {0, 0}, {4, 0}, 4);
  task.tail = testing::path({{4, {4, 0}}, {6, {4, 2}}});
  const Trajectory late = testing::path({{0, {0, 0}}, {7, {4, 0}}});
  const Trajectory onwards = with_tail(world_, task, late);
  EXPECT_NEAR(onwards.end_time(), 9, 1e-9);
  EXPECT_EQ(hold_until(Subproblem{}, task), 0);  // it goes on: nobody waits for it to rest
  Subproblem subproblem;
  subproblem.horizon = 40;
  task.tail = testing::path({{4, {4, 0}}});
  EXPECT_EQ(hold_until(subproblem, task), 40);
  EXPECT_EQ(with_tail(world_, task, late), late);
}

}  // namespace
}  // namespace accord
