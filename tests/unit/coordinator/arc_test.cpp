#include "coordinator/arc.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/scenes.h"
#include "tests/unit/coordinator/scripted_workforce.h"

namespace accord {
namespace {

using ::testing::HasSubstr;
using testing::ScriptedWorkforce;

class ArcTest : public testing::MethodTest<Arc> {
 protected:
  // `pairs` of discs, far from each other; the two of a pair cross at right angles.
  static testing::SceneBuilder crossings(int pairs) {
    testing::SceneBuilder builder(-100, -100, 2000, 100);
    for (int i = 0; i < pairs; ++i) {
      const double x = 100 * i;
      builder.disk(0.5, {x - 5, 0}, {x + 5, 0}).disk(0.5, {x, -5}, {x, 5});
    }
    return builder;
  }
};

TEST_F(ArcTest, AsksForNoTeamWhereTheRobotsOwnPathsNeverMeet) {
  const Outcome outcome = run(
      testing::SceneBuilder(-9, -9, 9, 9).disk(0.5, {-5, 0}, {5, 0}).disk(0.5, {-5, 3}, {5, 3}));
  EXPECT_EQ(outcome.status, PlanStatus::kSolved);
  EXPECT_TRUE(workforce_.rounds.empty());
  EXPECT_EQ(method_->statistics().conflicts_found, 0u);
  EXPECT_DOUBLE_EQ(method_->statistics().lower_bound, 20);
}

TEST_F(ArcTest, CommitsWhatATeamIsGivenAndLooksForConflictsAgain) {
  workforce_.team = [](const Subproblem& s) { return ScriptedWorkforce::solved(s, 2); };
  const Outcome outcome = run(crossings(1));
  EXPECT_EQ(outcome.status, PlanStatus::kSolved) << outcome.message;
  EXPECT_DOUBLE_EQ(method_->schedule().path({0}).end_time(), 12);
  EXPECT_EQ(method_->statistics().conflicts_resolved, 1u);
  EXPECT_EQ(method_->statistics().solved_by, (std::map<std::string, std::uint64_t>{{"script", 1}}));
}

TEST_F(ArcTest, HasConflictsThatShareNoRobotsSolvedInOneRound) {
  workforce_.team = [](const Subproblem& s) { return ScriptedWorkforce::solved(s, 2); };
  EXPECT_EQ(run(crossings(4)).status, PlanStatus::kSolved);
  EXPECT_EQ(workforce_.rounds, (std::vector<std::size_t>{4}));
}

TEST_F(ArcTest, NamesTheRobotThatHasNoWayOnItsOwn) {
  workforce_.alone = [](const Subproblem& s) {
    return s.tasks[0].robot == RobotId{1} ? Resolution{} : ScriptedWorkforce::straight(s);
  };
  const Outcome outcome = run(crossings(1));
  EXPECT_EQ(outcome.status, PlanStatus::kInfeasible);
  EXPECT_THAT(outcome.message, HasSubstr("\"r1\""));
}

TEST_F(ArcTest, NamesTheRobotsOfAConflictThatNobodyCanResolve) {
  const Outcome outcome = run(crossings(2));
  EXPECT_EQ(outcome.status, PlanStatus::kInfeasible);
  EXPECT_THAT(outcome.message, HasSubstr("robots \"r0\" and \"r1\" at "));
  EXPECT_GT(method_->statistics().exhausted, 0u);
  EXPECT_TRUE(method_->statistics().solved_by.empty());
}

TEST_F(ArcTest, GivesUpOnResolutionsThatResolveNothingAndSaysWhichConflictIsLeft) {
  workforce_.team = ScriptedWorkforce::unchanged;
  const Outcome outcome = run(crossings(1));
  EXPECT_EQ(outcome.status, PlanStatus::kTimeout);
  EXPECT_THAT(outcome.message, HasSubstr("\"r0\" and \"r1\""));
}

TEST_F(ArcTest, SaysHowFarItHasComeWhenItIsStopped) {
  workforce_.team = [this](const Subproblem&) {
    stop_ = true;
    return Resolution{};
  };
  Outcome outcome = run(crossings(2));
  EXPECT_EQ(outcome.status, PlanStatus::kCancelled);
  EXPECT_THAT(outcome.message, HasSubstr("2 conflicts left, the earliest of robots \"r0\""));

  outcome = run(crossings(2));  // still stopped
  EXPECT_EQ(outcome.status, PlanStatus::kCancelled);
  EXPECT_THAT(outcome.message, HasSubstr("robot \"r0\""));
}

TEST_F(ArcTest, RefusesLocalPathsThatDoNotFitTheirWindow) {
  workforce_.team = [](const Subproblem& s) {
    Resolution wrong = ScriptedWorkforce::solved(s, 2);
    wrong.paths[1] = testing::path({{s.from, {77, 77}}, {s.from + 1, s.tasks[1].goal}});
    return wrong;
  };
  EXPECT_THROW(run(crossings(1)), std::logic_error);
}

}  // namespace
}  // namespace accord
