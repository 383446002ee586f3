#include "worker/cbs_mp.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/geometry/tolerances.h"
#include "common/planning/region.h"
#include "tests/support/scenes.h"
#include "tests/unit/worker/solver_contract.h"
#include "worker/constraints.h"

namespace accord {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::atomic<bool> kGoOn{false};

Subproblem whole(const Scene& scene) {
  Subproblem out;
  out.whole = true;
  out.horizon = kInfinity;
  out.limits = SolverLimits::unlimited();
  for (std::uint32_t id = 0; id < scene.robots.size(); ++id) {
    const Robot& robot = scene.robot({id});
    out.tasks.push_back({{id},
                         1,
                         robot.start,
                         10,
                         robot.goal,
                         whole_region(scene, {id}),
                         testing::path({{0, robot.start}, {10, robot.goal}}),
                         {},
                         -1});
  }
  return out;
}

double sum_of_arrivals(const Resolution& resolution) {
  double sum = 0;
  for (const Trajectory& path : resolution.paths) sum += path.end_time();
  return sum;
}

TEST(CbsMp, LetsOneOfTwoThatCrossWaitAMomentOrGoAround) {
  const auto scene = testing::SceneBuilder(-8, -8, 8, 8)
                         .disk(0.5, {-5, 0}, {5, 0})
                         .disk(0.5, {0, -5}, {0, 5})
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  const Subproblem problem = whole(*scene);
  const Resolution found = CbsMp().solve(Workspace(world), problem, kGoOn);
  ASSERT_TRUE(found.solved);
  EXPECT_EQ(testing::contract_breach(world, problem, found), "");
  EXPECT_LT(sum_of_arrivals(found), 21.5);  // waiting costs 1.42 s, each on its own 10 s
  const Resolution again = CbsMp().solve(Workspace(world), problem, kGoOn);
  EXPECT_EQ(found.paths, again.paths);
}

TEST(CbsMp, LetsTwoThatChangePlacesGoAroundEachOther) {
  const auto scene = testing::SceneBuilder(-8, -8, 8, 8)
                         .disk(0.5, {-5, 0}, {5, 0})
                         .disk(0.5, {5, 0}, {-5, 0})
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  const Resolution found = CbsMp().solve(Workspace(world), whole(*scene), kGoOn);
  ASSERT_TRUE(found.solved);
  EXPECT_EQ(testing::contract_breach(world, whole(*scene), found), "");
}

TEST(CbsMp, LeavesSubproblemsWithOutsidersToOthers) {
  const auto scene = testing::SceneBuilder(-8, -8, 8, 8)
                         .disk(0.5, {-5, 0}, {5, 0})
                         .disk(0.5, {0, -5}, {0, 5})
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  Subproblem problem = whole(*scene);
  problem.outsiders.push_back({{1}, 1, problem.tasks.back().guide, kInfinity});
  problem.tasks.pop_back();
  EXPECT_FALSE(CbsMp().solve(Workspace(world), problem, kGoOn).solved);
}

TEST(Constraints, KeepARobotFromANodeWhileItIsForbidden) {
  Constraints constraints(1);
  constraints.add({7, 7, {4, 6}});
  constraints.add({7, 7, {2, 3}});
  constraints.add({7, 7, {5, 8}});
  std::vector<Interval> safe;
  constraints.safe_intervals(7, 0, safe);
  ASSERT_EQ(safe.size(), 3u);
  EXPECT_EQ(safe[0].lo, 1);
  EXPECT_EQ(safe[0].hi, 2);
  EXPECT_EQ(safe[1].lo, 3);
  EXPECT_EQ(safe[1].hi, 4);
  EXPECT_EQ(safe[2].lo, 8);
  EXPECT_EQ(safe[2].hi, kInfinity);
  constraints.safe_intervals(8, 0, safe);
  ASSERT_EQ(safe.size(), 1u);
  constraints.add({7, 7, {8, kInfinity}});
  constraints.safe_intervals(7, 0, safe);
  EXPECT_EQ(safe.size(), 2u);
}

TEST(Constraints, DelayDeparturesAlongAForbiddenEdgeInOneDirectionOnly) {
  Constraints constraints(0);
  constraints.add({1, 2, {0, 3}});
  constraints.add({1, 2, {2, 5}});
  const LocalRoadmap::Edge there{2, 0, 1.0}, back{1, 0, 1.0};
  EXPECT_EQ(constraints.earliest_departure(1, there, 0, 9), 5);
  EXPECT_EQ(constraints.earliest_departure(1, there, 6, 9), 6);
  EXPECT_EQ(constraints.earliest_departure(1, there, 0, 4), std::nullopt);
  EXPECT_EQ(constraints.earliest_departure(2, back, 0, 9), 0);
}

}  // namespace
}  // namespace accord
