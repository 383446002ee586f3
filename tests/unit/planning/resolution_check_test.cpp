#include "common/planning/resolution_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "common/geometry/tolerances.h"
#include "tests/support/problems.h"

namespace accord {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;
using testing::path;
using testing::Problem;
using testing::SceneBuilder;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Less than any clearance could hide, more than rounding.
constexpr double kHair = 1e-7;

std::optional<std::string> fault_of(const Problem& problem, const Resolution& resolution) {
  const CollisionWorld world(problem.scene, kDetectionMargin);
  return resolution_fault(world, problem.subproblem, resolution);
}

Resolution solved(std::vector<Trajectory> paths) {
  Resolution out;
  out.solved = true;
  out.solver = "test";
  out.paths = std::move(paths);
  for (const Trajectory& one : out.paths) out.end = std::max(out.end, one.end_time());
  return out;
}

// One disc of radius 0.5 along y = 0 from x = -5 to 5, in 10 s.
Problem alone(SceneBuilder builder = SceneBuilder(-8, -8, 8, 8)) {
  return testing::whole_problem(builder.disk(0.5, {-5, 0}, {5, 0}).build(), 1);
}
Trajectory straight() {
  return path({{0, {-5, 0}}, {10, {5, 0}}});
}

// Of crossing_discs(): the second waits for 3 s.
Resolution second_waits() {
  return solved({straight(), path({{0, {0, -5}}, {3, {0, -5}}, {13, {0, 5}}})});
}

// Two discs side by side along x for 10 s, `apart` (m) from each other's rim.
Problem side_by_side(double apart) {
  Problem problem = testing::whole_problem(SceneBuilder(-8, -8, 8, 8)
                                               .disk(0.5, {-5, 0}, {5, 0})
                                               .disk(0.5, {-5, 1 + apart}, {5, 1 + apart})
                                               .build(),
                                           2);
  return problem;
}
Resolution both_straight(const Problem& problem) {
  std::vector<Trajectory> paths;
  for (const Task& task : problem.subproblem.tasks) {
    paths.push_back(path({{0, task.start}, {10, task.goal}}));
  }
  return solved(std::move(paths));
}

TEST(ResolutionFault, IsNoneWhereAllIsWell) {
  EXPECT_EQ(fault_of(alone(), solved({straight()})), std::nullopt);
  EXPECT_EQ(fault_of(testing::crossing_discs(), second_waits()), std::nullopt);
}

TEST(ResolutionFault, IsNoneWhereNothingIsClaimed) {
  Resolution exhausted;
  EXPECT_EQ(fault_of(alone(), exhausted), std::nullopt);
  exhausted.paths = {path({{7, {0, 0}}})};
  EXPECT_EQ(fault_of(alone(), exhausted), std::nullopt);
}

TEST(ResolutionFault, IsInTheForm) {
  const auto with = [](const std::function<void(Resolution&)>& change) {
    Resolution resolution = solved({straight()});
    change(resolution);
    return fault_of(alone(), resolution);
  };
  EXPECT_THAT(with([](Resolution& r) { r.paths.clear(); }), Optional(HasSubstr("a path a robot")));
  EXPECT_THAT(with([](Resolution& r) { r.paths[0] = Trajectory(2); }),
              Optional(HasSubstr("\"r0\" has no path")));
  EXPECT_THAT(with([](Resolution& r) {
                r.paths[0] = path({{0, {-5, 0, 0}}, {10, {5, 0, 0}}});
              }),
              Optional(HasSubstr("its own size")));
  EXPECT_THAT(with([](Resolution& r) {
                r.paths[0] = path({{0, {-5, 0}}, {1, {-5, 0}}, {11, {5, 0}}});
                r.end = 12;
              }),
              Optional(HasSubstr("arrives at t = 11.000 s, not at t = 12.000 s")));
  EXPECT_THAT(with([](Resolution& r) {
                r.paths[0] = path({{1e-9, {-5, 0}}, {10.1, {5, 0}}});
                r.end = 10.1;
              }),
              Optional(HasSubstr("sets out at")));
  EXPECT_THAT(with([](Resolution& r) {
                r.paths[0] = path({{0, {-5, 1e-12}}, {10, {5, 0}}});
              }),
              Optional(HasSubstr("does not begin at its start")));
  EXPECT_THAT(with([](Resolution& r) {
                r.paths[0] = path({{0, {-5, 0}}, {10, {5, 2e-9}}});
              }),
              Optional(HasSubstr("does not end at its goal")));
  EXPECT_THAT(with([](Resolution& r) { r.left = {{0}}; }), Optional(HasSubstr("leave nobody")));
}

TEST(ResolutionFault, IsAMotionThatIsFasterThanTheRobot) {
  const auto with_end = [](double end) {
    return fault_of(alone(), solved({path({{0, {-5, 0}}, {end, {5, 0}}})}));
  };
  EXPECT_EQ(with_end(10 * (1 + 1e-8)), std::nullopt);
  EXPECT_THAT(with_end(10 * (1 - 2e-6)), Optional(HasSubstr("faster than it can")));
  const Problem arms = testing::arms_that_change_sides();
  Problem one = arms;
  one.subproblem.tasks.pop_back();
  const Configuration &start = one.subproblem.tasks[0].start, &goal = one.subproblem.tasks[0].goal;
  EXPECT_THAT(fault_of(one, solved({path({{0, start}, {1.5999, goal}})})),
              Optional(HasSubstr("faster than it can")));
}

TEST(ResolutionFault, IsAnObstacleThatIsTooCloseByAHair) {
  const auto beside = [](double gap) {
    SceneBuilder builder(-8, -8, 8, 8);
    builder.clearance(0.1).box(-1, 0.6 + gap, 1, 2);
    return fault_of(alone(builder), solved({straight()}));
  };
  EXPECT_EQ(beside(kPlanningMargin), std::nullopt);
  EXPECT_THAT(beside(-kHair), Optional(HasSubstr("\"r0\" comes too close to \"box 0\"")));
}

TEST(ResolutionFault, IsAnObstacleThatNoWaypointIsNear) {
  SceneBuilder builder(-8, -8, 8, 8);
  builder.box(-0.001, -0.001, 0.001, 0.001);
  EXPECT_THAT(fault_of(alone(builder), solved({straight()})),
              Optional(HasSubstr("comes too close to \"box 0\" at t = 4.499 s")));
}

TEST(ResolutionFault, IsNotLookedForOnThePresentPath) {
  SceneBuilder builder(-8, -8, 8, 8);
  builder.box(-1, -1, 1, 1);
  Problem problem = alone(builder);
  EXPECT_NE(fault_of(problem, solved({straight()})), std::nullopt);
  problem.subproblem.tasks[0].guide = straight();
  EXPECT_EQ(fault_of(problem, solved({straight()})), std::nullopt);
}

TEST(ResolutionFault, IsAWayOutOfTheBounds) {
  const auto over = [](double y) {
    return fault_of(alone(), solved({path({{0, {-5, 0}}, {10, {0, y}}, {20, {5, 0}}})}));
  };
  EXPECT_EQ(over(7.5), std::nullopt);
  EXPECT_THAT(over(7.5 + kHair), Optional(HasSubstr("leaves the scene's bounds")));
}

TEST(ResolutionFault, IsAnArmBeyondItsLimitsOrInItself) {
  const auto arm = testing::planar_arm_model({1, 1, 1});
  const Problem problem = testing::whole_problem(
      SceneBuilder(-4, -4, 4, 4).robot(arm, {0, 0.5, 0.5}, {0, 1, 1}).build(), 1);
  const auto over = [&](const Configuration& middle) {
    const Task& task = problem.subproblem.tasks[0];
    return fault_of(problem, solved({path({{0, task.start}, {10, middle}, {20, task.goal}})}));
  };
  EXPECT_EQ(over({1, 0.5, 0.5}), std::nullopt);
  EXPECT_THAT(over({3.1 + kHair, 0.5, 0.5}), Optional(HasSubstr("leaves its limits")));
  EXPECT_THAT(over({0, 2.4, 2.4}), Optional(HasSubstr("comes too close to itself")));
}

TEST(ResolutionFault, IsAConfigurationThatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(fault_of(alone(), solved({path({{0, {-5, 0}}, {10, {0, nan}}, {20, {5, 0}}})})),
              Optional(HasSubstr("\"r0\"")));
  EXPECT_THAT(fault_of(alone(), solved({path({{0, {-5, 0}}, {10, {5, nan}}})})),
              Optional(HasSubstr("\"r0\"")));
}

TEST(ResolutionFault, IsARestInWhatIsNotFree) {
  SceneBuilder builder(-8, -8, 8, 8);
  builder.box(-5, -1, -4, 1).disk(0.5, {-5, 0}, {-5, 0});
  const Problem problem = testing::whole_problem(builder.build(), 1);
  Resolution resolution = solved({path({{0, {-5, 0}}})});
  EXPECT_THAT(fault_of(problem, resolution), Optional(HasSubstr("comes too close")));
}

TEST(ResolutionFault, IsATeammateThatIsTooCloseByAHair) {
  for (const double sign : {1.0, -1.0}) {
    const Problem problem = side_by_side(sign > 0 ? kPlanningMargin : -kHair);
    const auto fault = fault_of(problem, both_straight(problem));
    if (sign > 0) {
      EXPECT_EQ(fault, std::nullopt);
    } else {
      EXPECT_THAT(fault, Optional(HasSubstr("come too close to each other at t = 0.000 s")));
    }
  }
}

TEST(ResolutionFault, IsATeammateOfAnyShape) {
  const Problem problem = testing::swapping_carts();
  const auto over = [&](double y) {
    const Task &first = problem.subproblem.tasks[0], &second = problem.subproblem.tasks[1];
    return fault_of(problem, solved({path({{0, first.start}, {10, {0, y, 0}}, {20, first.goal}}),
                                     path({{0, second.start}, {20, second.goal}})}));
  };
  EXPECT_EQ(over(3), std::nullopt);
  EXPECT_THAT(over(0.6), Optional(HasSubstr("\"r1\" and \"r0\" come too close")));
}

TEST(ResolutionFault, IsAnOutsiderThatIsTooCloseByAHair) {
  const auto beside = [](double apart, double until) {
    Problem problem = side_by_side(apart);
    const Task gone = problem.subproblem.tasks[1];
    problem.subproblem.tasks.pop_back();
    problem.subproblem.outsiders.push_back(
        {gone.robot, 1, path({{0, gone.start}, {10, gone.goal}}), until});
    return fault_of(problem, solved({straight()}));
  };
  EXPECT_EQ(beside(kPlanningMargin, kInfinity), std::nullopt);
  EXPECT_THAT(beside(-kHair, kInfinity), Optional(HasSubstr("\"r1\" and \"r0\"")));
  EXPECT_NE(beside(-kHair, 0.1), std::nullopt);
}

// What happens to crossing_discs() where the second goes at once.
std::optional<std::string> crossing(const std::function<void(Problem&)>& change) {
  Problem problem = testing::crossing_discs();
  change(problem);
  return fault_of(problem, solved({straight(), path({{0, {0, -5}}, {10, {0, 5}}})}));
}

TEST(ResolutionFault, LooksNoFurtherThanACrowdDoes) {
  EXPECT_NE(crossing([](Problem&) {}), std::nullopt);
  EXPECT_NE(crossing([](Problem& p) { p.subproblem.clear_until = 5; }), std::nullopt);
  EXPECT_EQ(crossing([](Problem& p) { p.subproblem.clear_until = 4; }), std::nullopt);
}

// The first is there after 2 s, where the second passes after 5 s.
std::optional<std::string> passing_the_goal(const std::function<void(Problem&)>& change) {
  Problem problem = testing::whole_problem(
      SceneBuilder(-8, -8, 8, 8).disk(0.5, {-2, 0}, {0, 0}).disk(0.5, {0, -5}, {0, 5}).build(), 2);
  change(problem);
  return fault_of(problem,
                  solved({path({{0, {-2, 0}}, {2, {0, 0}}}), path({{0, {0, -5}}, {10, {0, 5}}})}));
}

TEST(ResolutionFault, LooksAtARobotsRestOnlyWhereItDoesNotGoOn) {
  const auto goes_on = [](Problem& problem) {
    problem.subproblem.tasks[0].tail = path({{12, {0, 0}}, {18, {6, 0}}});
  };
  EXPECT_NE(passing_the_goal([](Problem&) {}), std::nullopt);
  EXPECT_EQ(passing_the_goal(goes_on), std::nullopt);
  EXPECT_EQ(passing_the_goal([](Problem& p) { p.subproblem.horizon = 3.9; }), std::nullopt);
  EXPECT_NE(passing_the_goal([](Problem& p) { p.subproblem.horizon = 5; }), std::nullopt);
}

// A crowd of two crossing discs that looks ahead for 9 s, not solved: `left` are left.
Resolution improved(std::vector<RobotId> left, std::vector<Trajectory> paths) {
  Resolution out = solved(std::move(paths));
  out.solved = false;
  out.left = std::move(left);
  return out;
}
Problem small_crowd() {
  Problem problem = testing::crossing_discs();
  problem.subproblem.clear_until = problem.subproblem.horizon = 9;
  return problem;
}

TEST(ResolutionFault, IsNoneOfWhoIsLeftOnItsPresentPath) {
  const Problem problem = small_crowd();
  const Trajectory& guide = problem.subproblem.tasks[1].guide;  // meets the first's
  const Trajectory slow = path({{0, {-5, 0}}, {12, {5, 0}}});
  EXPECT_EQ(fault_of(problem, improved({{1}}, {slow, guide})), std::nullopt);
  EXPECT_NE(fault_of(problem, solved({slow, guide})), std::nullopt);
  EXPECT_THAT(fault_of(problem, improved({{1}}, {slow, second_waits().paths[1]})),
              Optional(HasSubstr("not on its present path")));
  EXPECT_THAT(fault_of(problem, improved({{7}}, {slow, guide})),
              Optional(HasSubstr("not of the team")));
  EXPECT_THAT(fault_of(testing::crossing_discs(), improved({{1}}, {slow, guide})),
              Optional(HasSubstr("may leave nobody")));
}

TEST(ResolutionFault, IsAmongThoseOfACrowdThatAreNotLeft) {
  Problem problem = testing::crowd();
  problem.subproblem.outsiders.clear();
  std::vector<Trajectory> guides;
  for (const Task& task : problem.subproblem.tasks) guides.push_back(task.guide);
  std::vector<RobotId> but_two;
  for (std::uint32_t id = 2; id < guides.size(); ++id) but_two.push_back({id});
  EXPECT_NE(fault_of(problem, improved(but_two, guides)), std::nullopt);
  but_two.push_back({1});
  EXPECT_EQ(fault_of(problem, improved(but_two, guides)), std::nullopt);
}

// Three discs in lockstep; the third goes on as if alone, into the second.
TEST(ResolutionFault, OfACrowdInLockstepIsNoneWhereWhoHasNotArrivedMeetsOthersLater) {
  Problem problem = testing::whole_problem(SceneBuilder(-8, -8, 8, 8)
                                               .disk(0.5, {-5, 0}, {5, 0})
                                               .disk(0.5, {-5, 3}, {0, 3})
                                               .disk(0.5, {-5, 6}, {0, -6})
                                               .build(),
                                           3);
  problem.subproblem.lockstep = true;
  const auto third = [&](double sets_out, std::vector<RobotId> left) {
    Resolution resolution =
        solved({straight(), path({{0, {-5, 3}}, {10, {0, 3}}}),
                path({{0, {-5, 6}}, {sets_out, {-0, 6}}, {sets_out + 20, {0, -6}}})});
    resolution.left = std::move(left);
    return fault_of(problem, resolution);
  };
  EXPECT_EQ(third(10, {{2}}), std::nullopt);
  EXPECT_NE(third(10, {}), std::nullopt);
  EXPECT_NE(third(6, {{2}}), std::nullopt) << "before the others have arrived";
}

TEST(ResolutionFault, OfACrowdInLockstepIsNoOutsider) {
  Problem problem = alone();
  problem.subproblem.outsiders.push_back({{0}, 1, path({{0, {0, 0}}}), kInfinity});
  EXPECT_NE(fault_of(problem, solved({straight()})), std::nullopt);
  problem.subproblem.lockstep = true;
  EXPECT_EQ(fault_of(problem, solved({straight()})), std::nullopt);
}

}  // namespace
}  // namespace accord
