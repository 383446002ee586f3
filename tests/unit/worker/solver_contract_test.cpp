#include "tests/unit/worker/solver_contract.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/tolerances.h"
#include "common/planning/region.h"
#include "tests/support/scenes.h"
#include "worker/cbs_mp.h"

namespace accord {
namespace {

using testing::contract_breach;

const std::atomic<bool> kGoOn{false};

// A scene with its robots' straight ways as one subproblem.
struct Problem {
  std::shared_ptr<const Scene> scene;
  Subproblem subproblem;
};

Problem whole_problem(std::shared_ptr<const Scene> scene, std::size_t members) {
  Subproblem subproblem;
  subproblem.seed = 5;
  subproblem.to = 12;
  subproblem.horizon = 60;
  subproblem.whole = true;
  for (std::uint32_t id = 0; id < scene->robots.size(); ++id) {
    const Robot& robot = scene->robot({id});
    const Trajectory guide = testing::path({{0, robot.start}, {12, robot.goal}});
    if (id < members) {
      subproblem.tasks.push_back(
          {{id}, 1, robot.start, 12, robot.goal, whole_region(*scene, {id}), guide, {}, -1});
    } else {
      subproblem.outsiders.push_back({{id}, 1, guide, subproblem.horizon});
    }
  }
  return {std::move(scene), std::move(subproblem)};
}

Problem crossing_discs() {
  return whole_problem(testing::SceneBuilder(-8, -8, 8, 8)
                           .disk(0.5, {-5, 0}, {5, 0})
                           .disk(0.5, {0, -5}, {0, 5})
                           .build(),
                       2);
}

Problem swapping_discs_and_a_passer_by() {
  return whole_problem(testing::SceneBuilder(-8, -8, 8, 8)
                           .disk(0.5, {-5, 0}, {5, 0})
                           .disk(0.5, {5, 0}, {-5, 0})
                           .disk(0.5, {-3, 6}, {3, -6})
                           .build(),
                       2);
}

// Neither can yield without the other: each has to back out of the corridor first.
Problem discs_in_a_corridor_with_a_pocket() {
  return whole_problem(testing::SceneBuilder(-6, -1, 6, 3)
                           .box(-6, 0.6, -0.6, 3)
                           .box(0.6, 0.6, 6, 3)
                           .box(-6, -1, 6, -0.6)
                           .disk(0.5, {-4, 0}, {4, 0})
                           .disk(0.5, {4, 0}, {-4, 0})
                           .build(),
                       2);
}

// The same with a niche instead of a pocket, one that leaves the disc 5 mm on each side.
Problem discs_in_a_corridor_with_a_niche() {
  return whole_problem(testing::SceneBuilder(-6, -0.6, 6, 2)
                           .box(-6, 0.6, -0.505, 2)
                           .box(0.505, 0.6, 6, 2)
                           .disk(0.5, {-4, 0}, {4, 0})
                           .disk(0.5, {4, 0}, {-4, 0})
                           .build(),
                       2);
}

Problem swapping_carts() {
  const auto cart = testing::cart_model(1.0, 0.6);
  return whole_problem(testing::SceneBuilder(-6, -6, 6, 6)
                           .robot(cart, {-3, 0, 0}, {3, 0, 0})
                           .robot(cart, {3, 0, 3.1}, {-3, 0, 3.1})
                           .build(),
                       2);
}

Problem arms_that_change_sides() {
  const auto arm = testing::planar_arm_model({1, 0.8});
  Pose across = Pose::Identity();
  across.translation() = Vec3(2.2, 0, 0);
  across.linear() = Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()).toRotationMatrix();
  return whole_problem(testing::SceneBuilder(-3, -3, 5, 3)
                           .robot(arm, {0.8, 0}, {-0.8, 0})
                           .robot(arm, {0.8, 0}, {-0.8, 0}, across)
                           .build(),
                       2);
}

// Many discs that change places across a circle, and look 9 s ahead.
Problem crowd() {
  testing::SceneBuilder builder(-8, -8, 8, 8);
  for (int i = 0; i < 11; ++i) {
    const double angle = 2 * std::numbers::pi * i / 11;
    const double x = 6 * std::cos(angle), y = 6 * std::sin(angle);
    builder.disk(0.4, {x, y}, {-x, -y});
  }
  Problem problem = whole_problem(builder.build(), 10);
  problem.subproblem.clear_until = problem.subproblem.horizon = 9;
  problem.subproblem.outsiders.front().until = 9;
  return problem;
}

Problem crowd_in_lockstep() {
  Problem problem = crowd();
  problem.subproblem.outsiders.clear();
  problem.subproblem.clear_until = std::numeric_limits<double>::infinity();
  problem.subproblem.lockstep = true;
  return problem;
}

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
