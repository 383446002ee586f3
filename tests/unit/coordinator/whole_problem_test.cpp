#include "coordinator/whole_problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/scenes.h"
#include "tests/unit/coordinator/scripted_workforce.h"

namespace accord {
namespace {

using ::testing::HasSubstr;
using testing::ScriptedWorkforce;

class WholeProblemTest : public testing::MethodTest<WholeProblem> {
 protected:
  // Three discs, of which two conflict.
  static testing::SceneBuilder three() {
    return testing::SceneBuilder(-9, -9, 9, 9)
        .disk(0.5, {-5, 0}, {5, 0})
        .disk(0.5, {0, -5}, {0, 5})
        .disk(0.5, {-5, 8}, {5, 8});
  }
};

TEST_F(WholeProblemTest, AsksNobodyWhereTheRobotsOwnPathsNeverMeet) {
  const Outcome outcome = run(
      testing::SceneBuilder(-9, -9, 9, 9).disk(0.5, {-5, 0}, {5, 0}).disk(0.5, {-5, 3}, {5, 3}));
  EXPECT_EQ(outcome.status, PlanStatus::kSolved);
  EXPECT_TRUE(workforce_.rounds.empty());
}

TEST_F(WholeProblemTest, PutsAllRobotsFromStartToGoalToTheSolverAtOnce) {
  workforce_.team = [](const Subproblem& s) {
    EXPECT_EQ(s.tasks.size(), 3u);
    EXPECT_TRUE(s.is_last());
    EXPECT_EQ(s.from, 0);
    EXPECT_EQ(s.horizon, std::numeric_limits<double>::infinity());
    EXPECT_EQ(s.limits.priority_orders, 1u);
    for (const Task& task : s.tasks) {
      EXPECT_EQ(task.tail.size(), 1u);
      EXPECT_EQ(task.region.lower, (Configuration{-9, -9}));
      EXPECT_EQ(task.guide.end_time(), task.to);
    }
    return ScriptedWorkforce::solved(s, 2);
  };
  const Outcome outcome = run(three());
  EXPECT_EQ(outcome.status, PlanStatus::kSolved) << outcome.message;
  EXPECT_EQ(workforce_.rounds, (std::vector<std::size_t>{1}));
  EXPECT_DOUBLE_EQ(method_->schedule().path({0}).end_time(), 12);
  EXPECT_EQ(method_->statistics().solved_by.at("script"), 1u);
}

TEST_F(WholeProblemTest, NamesTheConflictThatTheSolverCouldNotResolve) {
  const Outcome outcome = run(three());
  EXPECT_EQ(outcome.status, PlanStatus::kInfeasible);
  EXPECT_THAT(outcome.message, HasSubstr("\"r0\" and \"r1\""));
}

TEST_F(WholeProblemTest, SaysWhatWasLeftWhenItIsStopped) {
  workforce_.team = [this](const Subproblem&) {
    stop_ = true;
    return Resolution{};
  };
  const Outcome outcome = run(three());
  EXPECT_EQ(outcome.status, PlanStatus::kCancelled);
  EXPECT_THAT(outcome.message, HasSubstr("1 conflicts left"));
}

}  // namespace
}  // namespace accord
