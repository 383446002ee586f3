#include "common/planning/levels.h"

#include <gtest/gtest.h>

#include "common/planning/method_names.h"

namespace accord {
namespace {

using Names = std::vector<std::string>;

TEST(Levels, OfATeamAreAllButTheOneForLockstep) {
  EXPECT_EQ(levels_of(Subproblem{}, default_solver_names()),
            (Names{"prioritized-query", "decoupled-prm", "composite-prm"}));
}

TEST(Levels, OfACrowdHoldNoJointSpace) {
  Subproblem crowd;
  crowd.clear_until = 5;
  EXPECT_EQ(levels_of(crowd, local_solver_names()), (Names{"prioritized-query", "decoupled-prm"}));
}

TEST(Levels, OfACrowdInLockstepAreThatAlone) {
  Subproblem crowd;
  crowd.lockstep = true;
  EXPECT_EQ(levels_of(crowd, local_solver_names()), (Names{"lockstep-query"}));
}

TEST(Levels, LeaveCbsToWholeProblems) {
  Subproblem whole;
  EXPECT_FALSE(is_meant_for("cbs-mp", whole));
  whole.whole = true;
  EXPECT_TRUE(is_meant_for("cbs-mp", whole));
}

TEST(Levels, AreNotForARobotOnItsOwnThatHasNobodyToAvoid) {
  Subproblem subproblem;
  subproblem.tasks.resize(1);
  EXPECT_TRUE(is_robot_alone(subproblem));
  subproblem.outsiders.resize(1);
  EXPECT_FALSE(is_robot_alone(subproblem));
}

using Tried = std::vector<TriedLevel>;

Resolution solved_by(const char* solver) {
  Resolution resolution;
  resolution.solved = true;
  resolution.solver = solver;
  return resolution;
}

TEST(TriedLevels, EndWithTheOneThatSolvesIt) {
  const Subproblem team;
  EXPECT_EQ(tried_levels(team, default_solver_names(), solved_by("decoupled-prm")),
            (Tried{{"prioritized-query", LevelOutcome::kExhausted},
                   {"decoupled-prm", LevelOutcome::kSolved}}));
  EXPECT_EQ(tried_levels(team, {"lockstep-query", "decoupled-prm"}, {}),
            (Tried{{"decoupled-prm", LevelOutcome::kExhausted}}));
}

TEST(TriedLevels, OfARobotAloneAreHowItIsGivenItsPath) {
  Subproblem alone;
  alone.tasks.resize(1);
  EXPECT_EQ(tried_levels(alone, default_solver_names(), solved_by("straight")),
            (Tried{{"straight", LevelOutcome::kSolved}}));
  EXPECT_EQ(tried_levels(alone, default_solver_names(), {}),
            (Tried{{"prm", LevelOutcome::kExhausted}}));
}

// A worker may say anything.
TEST(TriedLevels, NameASolverThatIsNoneOfThemLast) {
  const auto tried = tried_levels(Subproblem{}, {"decoupled-prm"}, solved_by("magic"));
  ASSERT_EQ(tried.size(), 2U);
  EXPECT_EQ(counted_solver(tried.back().solver), "other");
}

}  // namespace
}  // namespace accord
