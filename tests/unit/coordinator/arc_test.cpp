#include "coordinator/arc.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "common/geometry/tolerances.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

using ::testing::HasSubstr;

// Robots on their own go straight; what becomes of teams is up to the test.
class ScriptedWorkforce final : public Workforce {
 public:
  std::function<Resolution(const Subproblem&)> alone = straight;
  std::function<Resolution(const Subproblem&)> team = exhausted;
  std::vector<std::size_t> rounds;  // how many teams were to be solved at once

  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>&) override {
    std::vector<Resolution> out;
    for (const Subproblem& subproblem : subproblems) {
      out.push_back(subproblem.tasks.size() == 1 ? alone(subproblem) : team(subproblem));
    }
    if (subproblems.front().tasks.size() > 1) rounds.push_back(subproblems.size());
    return out;
  }

  static Resolution exhausted(const Subproblem&) { return {}; }

  static Resolution straight(const Subproblem& subproblem) {
    Resolution out = solved(subproblem, 0);
    const Task& task = subproblem.tasks[0];
    out.end = std::hypot(task.goal[0] - task.start[0], task.goal[1] - task.start[1]);
    out.paths = {testing::path({{0, task.start}, {out.end, task.goal}})};
    return out;
  }

  // Everyone keeps to its path, but for the first, which waits at its start.
  static Resolution solved(const Subproblem& subproblem, double wait) {
    Resolution out;
    out.solved = true;
    out.solver = "script";
    for (const Task& task : subproblem.tasks) {
      Trajectory path(task.goal.size());
      const double delay = out.paths.empty() ? wait : 0;
      path.append(subproblem.from, task.start);
      if (delay > 0) path.append(subproblem.from + delay, task.start);
      if (task.to > subproblem.from) path.append(task.to + delay, task.goal);
      out.end = std::max(out.end, path.end_time());
      out.paths.push_back(std::move(path));
    }
    return out;
  }

  static Resolution unchanged(const Subproblem& subproblem) {
    Resolution out = solved(subproblem, 0);
    for (std::size_t i = 0; i < out.paths.size(); ++i) out.paths[i] = subproblem.tasks[i].guide;
    return out;
  }
};

class ArcTest : public ::testing::Test {
 protected:
  ArcOutcome run(const testing::SceneBuilder& builder) {
    const auto scene = builder.build();
    planning_.emplace(scene, kPlanningMargin);
    detection_.emplace(scene, 0.5 * kPlanningMargin);
    arc_.emplace(*planning_, *detection_, 1, workforce_, stop_, nullptr);
    return arc_->run();
  }

  // `pairs` of discs, far from each other; the two of a pair cross at right angles.
  static testing::SceneBuilder crossings(int pairs) {
    testing::SceneBuilder builder(-100, -100, 2000, 100);
    for (int i = 0; i < pairs; ++i) {
      const double x = 100 * i;
      builder.disk(0.5, {x - 5, 0}, {x + 5, 0}).disk(0.5, {x, -5}, {x, 5});
    }
    return builder;
  }

  ScriptedWorkforce workforce_;
  std::atomic<bool> stop_{false};
  std::optional<CollisionWorld> planning_, detection_;
  std::optional<Arc> arc_;
};

TEST_F(ArcTest, AsksForNoTeamWhereTheRobotsOwnPathsNeverMeet) {
  const ArcOutcome outcome = run(
      testing::SceneBuilder(-9, -9, 9, 9).disk(0.5, {-5, 0}, {5, 0}).disk(0.5, {-5, 3}, {5, 3}));
  EXPECT_EQ(outcome.status, PlanStatus::kSolved);
  EXPECT_TRUE(workforce_.rounds.empty());
  EXPECT_EQ(arc_->statistics().conflicts_found, 0u);
  EXPECT_DOUBLE_EQ(arc_->statistics().lower_bound, 20);
}

TEST_F(ArcTest, CommitsWhatATeamIsGivenAndLooksForConflictsAgain) {
  workforce_.team = [](const Subproblem& s) { return ScriptedWorkforce::solved(s, 2); };
  const ArcOutcome outcome = run(crossings(1));
  EXPECT_EQ(outcome.status, PlanStatus::kSolved) << outcome.message;
  EXPECT_DOUBLE_EQ(arc_->schedule().path({0}).end_time(), 12);
  EXPECT_EQ(arc_->statistics().conflicts_resolved, 1u);
  EXPECT_EQ(arc_->statistics().solved_by, (std::map<std::string, std::uint64_t>{{"script", 1}}));
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
  const ArcOutcome outcome = run(crossings(1));
  EXPECT_EQ(outcome.status, PlanStatus::kInfeasible);
  EXPECT_THAT(outcome.message, HasSubstr("\"r1\""));
}

TEST_F(ArcTest, NamesTheRobotsOfAConflictThatNobodyCanResolve) {
  const ArcOutcome outcome = run(crossings(2));
  EXPECT_EQ(outcome.status, PlanStatus::kInfeasible);
  EXPECT_THAT(outcome.message, HasSubstr("robots \"r0\" and \"r1\" at "));
  EXPECT_GT(arc_->statistics().exhausted, 0u);
  EXPECT_TRUE(arc_->statistics().solved_by.empty());
}

TEST_F(ArcTest, GivesUpOnResolutionsThatResolveNothingAndSaysWhichConflictIsLeft) {
  workforce_.team = ScriptedWorkforce::unchanged;
  const ArcOutcome outcome = run(crossings(1));
  EXPECT_EQ(outcome.status, PlanStatus::kTimeout);
  EXPECT_THAT(outcome.message, HasSubstr("\"r0\" and \"r1\""));
}

TEST_F(ArcTest, SaysHowFarItHasComeWhenItIsStopped) {
  workforce_.team = [this](const Subproblem&) {
    stop_ = true;
    return Resolution{};
  };
  ArcOutcome outcome = run(crossings(2));
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
