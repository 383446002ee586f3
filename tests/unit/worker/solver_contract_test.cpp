#include "tests/unit/worker/solver_contract.h"
#include "common/planning/method_names.h"

#include <gtest/gtest.h>

#include "common/geometry/tolerances.h"
#include "common/planning/resolution_check.h"
#include "tests/support/problems.h"
#include "worker/cbs_mp.h"

namespace accord {
namespace {

using testing::arms_that_change_sides;
using testing::contract_breach;
using testing::crossing_discs;
using testing::crowd;
using testing::crowd_in_lockstep;
using testing::discs_in_a_corridor_with_a_niche;
using testing::discs_in_a_corridor_with_a_pocket;
using testing::Problem;
using testing::swapping_carts;
using testing::swapping_discs_and_a_passer_by;

const std::atomic<bool> kGoOn{false};

using Case = std::tuple<std::string, Problem (*)()>;

class SolverContract : public ::testing::TestWithParam<Case> {
 protected:
  SolverContract()
      : problem_(std::get<1>(GetParam())()),
        world_(problem_.scene, kPlanningMargin),
        workspace_(world_),
        solver_(make_solver(std::get<0>(GetParam()))) {}

  Resolution solve(const std::atomic<bool>& stop = kGoOn) const {
    return solver_->solve(workspace_, problem_.subproblem, stop);
  }

  Problem problem_;
  CollisionWorld world_;
  Workspace workspace_;
  std::unique_ptr<Solver> solver_;
};

TEST_P(SolverContract, WhatItSolvesIsFreeAndFitsTheWindow) {
  EXPECT_EQ(contract_breach(world_, problem_.subproblem, solve()), "");
}

TEST_P(SolverContract, WhatItReturnsIsNotRefused) {
  const CollisionWorld detection(problem_.scene, kDetectionMargin);
  EXPECT_EQ(resolution_fault(detection, problem_.subproblem, solve()), std::nullopt);
}

TEST_P(SolverContract, TheSameSubproblemGivesTheSameResolution) {
  const Resolution first = solve(), second = solve();
  EXPECT_EQ(first.solved, second.solved);
  EXPECT_EQ(first.end, second.end);
  EXPECT_EQ(first.paths, second.paths);
  EXPECT_EQ(first.effort.expansions, second.effort.expansions);
}

TEST_P(SolverContract, EndsUnsolvedWhenToldToStop) {
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(solve(stop).solved);
}

std::vector<std::string> all_solver_names() {
  std::vector<std::string> names = local_solver_names();
  names.emplace_back(CbsMp::kName);
  return names;
}

INSTANTIATE_TEST_SUITE_P(
    All, SolverContract,
    ::testing::Combine(::testing::ValuesIn(all_solver_names()),
                       ::testing::Values(crossing_discs, swapping_discs_and_a_passer_by,
                                         discs_in_a_corridor_with_a_pocket, swapping_carts,
                                         arms_that_change_sides, crowd, crowd_in_lockstep)));

// The suite must be able to fail: a solver that hands the guides back is caught.
TEST(SolverContractItself, CatchesASolverThatIgnoresConflicts) {
  const Problem problem = crossing_discs();
  const CollisionWorld world(problem.scene, kPlanningMargin);
  Resolution wrong;
  wrong.solved = true;
  wrong.end = 12;
  for (const Task& task : problem.subproblem.tasks) wrong.paths.push_back(task.guide);
  EXPECT_EQ(contract_breach(world, problem.subproblem, wrong), "two robots of the team meet");
}

TEST(CompositeRrtConnect, BacksOneDiscOutOfTheOthersWay) {
  const Problem problem = discs_in_a_corridor_with_a_pocket();
  const CollisionWorld world(problem.scene, kPlanningMargin);
  const auto found =
      make_solver("composite-rrt-connect")->solve(Workspace(world), problem.subproblem, kGoOn);
  EXPECT_TRUE(found.solved);
  EXPECT_EQ(found.solver, "composite-rrt-connect");
}

TEST(CompositePrm, FindsTheNicheThatOneDiscHardlyFitsInto) {
  const Problem problem = discs_in_a_corridor_with_a_niche();
  const CollisionWorld world(problem.scene, kPlanningMargin);
  const Resolution found =
      make_solver("composite-prm")->solve(Workspace(world), problem.subproblem, kGoOn);
  EXPECT_TRUE(found.solved);
  EXPECT_EQ(contract_breach(world, problem.subproblem, found), "");
}

TEST(CompositePrm, EndsSoonWhereOutsidersMayBeWhatIsInTheWay) {
  Problem problem = discs_in_a_corridor_with_a_pocket();
  const Robot& parked = problem.scene->robot({0});
  problem.subproblem.outsiders.push_back(
      {{0}, 1, testing::path({{0, parked.start}}), std::numeric_limits<double>::infinity()});
  problem.subproblem.tasks.erase(problem.subproblem.tasks.begin());
  const CollisionWorld world(problem.scene, kPlanningMargin);
  const Resolution found =
      make_solver("composite-prm")->solve(Workspace(world), problem.subproblem, kGoOn);
  EXPECT_FALSE(found.solved);
  EXPECT_LE(found.effort.samples, problem.subproblem.limits.composite_nodes);
}

TEST(Hierarchy, EachLevelSolvesWhatTheOnesBeforeItCannot) {
  const auto solver_of = [](Problem (*make)()) {
    const Problem problem = make();
    const CollisionWorld world(problem.scene, kPlanningMargin);
    return SolverHierarchy(default_solver_names())
        .solve(Workspace(world), problem.subproblem, kGoOn)
        .solver;
  };
  EXPECT_EQ(solver_of(crossing_discs), "prioritized-query");
  EXPECT_EQ(solver_of(swapping_discs_and_a_passer_by), "decoupled-prm");
  EXPECT_EQ(solver_of(discs_in_a_corridor_with_a_pocket), "composite-prm");
  EXPECT_EQ(solver_of(crowd), "prioritized-query");
  EXPECT_EQ(solver_of(crowd_in_lockstep), "lockstep-query");
}

}  // namespace
}  // namespace accord
