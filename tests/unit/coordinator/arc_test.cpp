#include "coordinator/arc.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>

#include "common/planning/identity.h"
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

// Asks for foresight, knowing what will become of everything, before it does anything. Has planning
// stopped after a while.
class Foreseeing final : public Workforce {
 public:
  Foreseeing(Workforce& workforce, std::atomic<bool>& stop) : workforce_(workforce), stop_(stop) {}

  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>& stop,
                                const Foresight& foresight) override {
    for (const Subproblem& subproblem : subproblems) {
      const bool was_foreseen = std::ranges::any_of(
          foreseen_, [&](const Subproblem& one) { return are_identical(one, subproblem); });
      if (foresaw_) ++(was_foreseen ? right : wrong);
    }
    const Likely likely = [&](const Subproblem& subproblem) {
      std::optional<Resolution> resolution;
      if (knows(subproblem)) resolution = workforce_.solve({subproblem}, stop, {}).front();
      return resolution;
    };
    foresaw_ = looks_ahead && foresight;
    if (foresaw_) foreseen_ = foresight(likely, 1000);
    if (foresaw_) look(subproblems, foreseen_);
    auto resolutions = workforce_.solve(subproblems, stop, {});
    constexpr int kCalls = 40;
    stop_ = ++calls_ == kCalls;
    return resolutions;
  }

  std::function<bool(const Subproblem&)> knows = [](const Subproblem&) { return true; };
  // At what was asked for and what was foreseen then.
  std::function<void(const std::vector<Subproblem>&, const std::vector<Subproblem>&)> look =
      [](const auto&, const auto&) {};
  bool looks_ahead = true;
  int right = 0, wrong = 0;

 private:
  Workforce& workforce_;
  std::atomic<bool>& stop_;
  int calls_ = 0;
  bool foresaw_ = false;
  std::vector<Subproblem> foreseen_;
};

// Discs that cross in many places. Every other team is exhausted, the others wait a little.
std::shared_ptr<const Scene> grid(ScriptedWorkforce& workforce) {
  workforce.team = [](const Subproblem& s) {
    return s.seed % 2 == 0 ? Resolution{} : ScriptedWorkforce::solved(s, 1);
  };
  testing::SceneBuilder builder(-40, -40, 40, 40);
  for (int i = 0; i < 6; ++i) {
    const double at = 6.0 * i - 15;
    builder.disk(0.5, {-20, at}, {20, at}).disk(0.5, {at, -20}, {at, 20});
  }
  return builder.build();
}

bool share_robots(const Subproblem& a, const Subproblem& b) {
  return std::ranges::any_of(a.tasks, [&](const Task& task) {
    return std::ranges::find(b.tasks, task.robot, &Task::robot) != b.tasks.end();
  });
}

TEST_F(ArcTest, ForeseesNothingForRobotsThatAreStillBeingPlanned) {
  const auto scene = grid(workforce_);
  const CollisionWorld planning(scene, kPlanningMargin), detection(scene, 0.5 * kPlanningMargin);
  Foreseeing foreseeing(workforce_, stop_);
  foreseeing.knows = [](const Subproblem& s) { return s.seed % 3 != 0; };
  int looked = 0;
  foreseeing.look = [&](const auto& asked, const auto& foreseen) {
    for (const Subproblem& one : asked) {
      if (foreseeing.knows(one)) continue;
      for (const Subproblem& later : foreseen) {
        ++looked;
        EXPECT_TRUE(later.seed == one.seed || !share_robots(later, one))
            << "its outsiders left out, or nothing";
      }
    }
  };
  Arc arc(planning, detection, 1, foreseeing, stop_, nullptr);
  arc.run();
  EXPECT_GT(looked, 10);
}

TEST_F(ArcTest, ForeseesAllThatItAsksForWhereItKnowsWhatIsLikely) {
  const auto scene = grid(workforce_);
  const CollisionWorld planning(scene, kPlanningMargin), detection(scene, 0.5 * kPlanningMargin);
  Foreseeing foreseeing(workforce_, stop_);
  Arc arc(planning, detection, 1, foreseeing, stop_, nullptr);
  arc.run();
  EXPECT_GT(foreseeing.right, 20);
  EXPECT_EQ(foreseeing.wrong, 0);
  // And looking ahead has changed nothing.
  stop_ = false;
  Foreseeing blind(workforce_, stop_);
  blind.looks_ahead = false;
  Arc plain(planning, detection, 1, blind, stop_, nullptr);
  plain.run();
  EXPECT_EQ(arc.statistics().conflicts_found, plain.statistics().conflicts_found);
  EXPECT_EQ(arc.statistics().pair_checks, plain.statistics().pair_checks);
  EXPECT_EQ(arc.statistics().distance_queries, plain.statistics().distance_queries);
  EXPECT_EQ(arc.statistics().rounds, plain.statistics().rounds);
  for (std::uint32_t id = 0; id < 12; ++id) {
    EXPECT_EQ(arc.schedule().path({id}), plain.schedule().path({id}));
  }
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
