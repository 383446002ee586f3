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

}  // namespace
}  // namespace accord
