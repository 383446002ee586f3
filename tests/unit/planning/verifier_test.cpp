#include "common/planning/verifier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "tests/unit/planning/verifier_scenes.h"

namespace accord {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Kind = Violation::Kind;

std::string words(const Verdict& verdict) {
  return verdict.violation ? verdict.violation->text : "proved";
}

// ---- Correct plans ----

TEST(Verifier, ProvesACorrectPlanAndSaysHowCloseItComes) {
  const auto scene = hall();
  const Verdict verdict = verify(scene, hall_plan(*scene));
  ASSERT_TRUE(verdict.proved()) << words(verdict);
  // left passes 1 m above the wall's end; below stays 2 m beside it.
  ASSERT_TRUE(verdict.obstacles);
  EXPECT_LE(verdict.obstacles->distance, 0.8);
  EXPECT_GT(verdict.obstacles->distance, 0.8 - 2e-3);
  EXPECT_EQ(verdict.obstacles->first, "left");
  EXPECT_EQ(verdict.obstacles->second, "wall");
  // left is past x = -2 long before below comes up.
  EXPECT_FALSE(verdict.robots);
}

TEST(Verifier, FindsTheClosestApproachOfDiscsInClosedForm) {
  const auto scene = hall();
  scene->robots[1].goal = {-2, 3.25};  // 0.75 m below left's way, and there after it
  Plan plan = plan_of(*scene, {path({{0, {-4, 4}}, {20, {0, 4}}, {24, {4, 4}}}),
                               path({{0, {-2, -4}}, {7.25, {-2, 3.25}}})});
  const Verdict verdict = verify(scene, plan);
  ASSERT_TRUE(verdict.proved()) << words(verdict);
  ASSERT_TRUE(verdict.robots);
  double least = 10;  // the same by brute force
  for (int i = 0; i <= 240000; ++i) {
    const double t = i * 1e-4;
    const Configuration a = plan.robots[0].trajectory.at(t);
    const Configuration b = plan.robots[1].trajectory.at(t);
    least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1]) - 0.4);
  }
  EXPECT_LE(verdict.robots->distance, least);
  EXPECT_GT(verdict.robots->distance, least - 1e-6);
  EXPECT_EQ(verdict.robots->first, "left");
  EXPECT_EQ(verdict.robots->second, "below");
}

TEST(Verifier, ProvesRobotsThatNeverMove) {
  const auto scene = hall();
  for (Robot& robot : scene->robots) robot.goal = robot.start;
  const Plan plan = plan_of(*scene, {path({{0, {-4, 4}}}), path({{0, {-2, -4}}})});
  EXPECT_TRUE(verify(scene, plan).proved()) << words(verify(scene, plan));
}

TEST(Verifier, ProvesAnArm) {
  const auto scene = arm_cell();
  const Verdict verdict = verify(scene, arm_plan(*scene));
  EXPECT_TRUE(verdict.proved()) << words(verdict);
}

TEST(Verifier, TakesGoalsThatDifferByAFullTurn) {
  const auto scene = arm_cell();
  auto model = std::make_shared<RobotModel>(*scene->robots[0].model);
  for (DegreeOfFreedom& dof : model->dofs) {
    dof.wraps = true;
    dof.lower = -std::numeric_limits<double>::infinity();
    dof.upper = std::numeric_limits<double>::infinity();
  }
  scene->robots[0].model = model;
  scene->robots[0].goal[0] += 2 * std::numbers::pi;
  EXPECT_TRUE(verify(scene, arm_plan(*scene)).proved());
}

TEST(Verifier, DoesNotDependOnTheOrderOfRobotsInThePlan) {
  const auto scene = hall();
  Plan plan = hall_plan(*scene);
  std::swap(plan.robots[0], plan.robots[1]);
  EXPECT_TRUE(verify(scene, plan).proved());
}

// ---- Broken ones ----

struct Break {
  const char* name;
  std::function<void(Scene&, Plan&)> apply;
  Kind kind;
  std::vector<std::string> robots;
  double time;  // s, to 1 ms
  const char* text;
};

void replace(Plan& plan, std::size_t robot, const std::vector<Waypoint>& waypoints) {
  plan.robots[robot].trajectory = path(waypoints);
  compute_costs(plan);
}

const Break kBreaks[] = {
    {"MissingRobot",
     [](Scene&, Plan& p) { p.robots.pop_back(); },
     Kind::kForm,
     {"below"},
     0,
     "missing"},
    {"UnknownRobot",
     [](Scene&, Plan& p) {
       p.robots.push_back(p.robots[0]);
       p.robots.back().name = "ghost";
     },
     Kind::kForm,
     {"ghost"},
     0,
     "no robot \"ghost\""},
    {"RobotTwice",
     [](Scene&, Plan& p) { p.robots.push_back(p.robots[0]); },
     Kind::kForm,
     {"left"},
     0,
     "twice"},
    {"NotSolved",
     [](Scene&, Plan& p) { p.status = PlanStatus::kTimeout; },
     Kind::kForm,
     {},
     0,
     "timeout"},
    {"NoWaypoints",
     [](Scene&, Plan& p) { p.robots[0].trajectory = Trajectory(2); },
     Kind::kForm,
     {"left"},
     0,
     "no waypoints"},
    {"WrongDimension",
     [](Scene&, Plan& p) {
       replace(p, 0, {{0, {-4, 4, 0}}, {8, {4, 4, 0}}});
     },
     Kind::kForm,
     {"left"},
     0,
     "3 numbers"},
    {"NotANumber",
     [](Scene&, Plan& p) {
       replace(p, 0, {{0, {-4, 4}}, {4, {std::nan(""), 4}}, {8, {4, 4}}});
     },
     Kind::kForm,
     {"left"},
     0,
     "waypoint 1"},
    {"BeginsLate",
     [](Scene&, Plan& p) {
       replace(p, 0, {{1, {-4, 4}}, {9, {4, 4}}});
     },
     Kind::kForm,
     {"left"},
     0,
     "t = 0"},
    {"StartMoved",
     [](Scene&, Plan& p) {
       replace(p, 0, {{0, {-4 + 1e-6, 4}}, {8, {4, 4}}});
     },
     Kind::kStart,
     {"left"},
     0,
     "x is off by"},
    {"GoalMissed",
     [](Scene&, Plan& p) {
       replace(p, 0, {{0, {-4, 4}}, {8, {4, 4 - 1e-5}}});
     },
     Kind::kGoal,
     {"left"},
     8,
     "y is off by"},
    {"SlightlyTooFast",
     [](Scene&, Plan& p) {
       replace(p, 0, {{0, {-4, 4}}, {4, {0, 4}}, {8 - 1e-4, {4, 4}}});
     },
     Kind::kSpeed,
     {"left"},
     4,
     "limit is 1"},
    {"Teleport",
     [](Scene&, Plan& p) {
       replace(p, 0, {{0, {-4, 4}}, {2, {-2, 4}}, {2.0001, {2, 4}}, {4.0001, {4, 4}}});
     },
     Kind::kSpeed,
     {"left"},
     2,
     "near (-2.00, 4.00)"},
    {"LeavesTheBounds",
     [](Scene&, Plan& p) {
       replace(p, 0, {{0, {-4, 4}}, {4, {-2, 5}}, {10, {4, 4}}});
     },
     Kind::kBounds,
     {"left"},
     3.2,
     "bounds"},
    // Straight through 1 cm of wall between two waypoints far off it.
    {"TunnelsThroughAThinWall",
     [](Scene&, Plan& p) {
       replace(p, 0, {{0, {-4, 4}}, {5, {-4, 0}}, {13, {4, 0}}, {17, {4, 4}}});
     },
     Kind::kObstacle,
     {"left"},
     5 + 4 - 0.005 - 0.3,
     "\"wall\""},
    // At 0.299 m from the wall's face: a millimetre less than radius and clearance.
    {"ClearanceShortByAMillimetre",
     [](Scene&, Plan& p) {
       replace(p, 1, {{0, {-2, -4}}, {2, {-0.304, -4}}, {4, {-0.304, -3}}, {10, {-2, 2}}});
     },
     Kind::kObstacle,
     {"below"},
     2 * (1.695 / 1.696),
     "0.0990 m"},
    // Both pass (-2, 4) at t = 2 and 10 at right angles; no waypoint is near.
    {"CollisionBetweenWaypoints",
     [](Scene& s, Plan& p) {
       s.robots[1].goal = {-2, 4.6};
       replace(p, 0, {{0, {-4, 4}}, {8.5, {-4, 4}}, {16.5, {4, 4}}});
       replace(p, 1, {{0, {-2, -4}}, {2.5, {-2, -4}}, {11.5, {-2, 4.6}}});
     },
     Kind::kRobots,
     {"left", "below"},
     -1,
     "overlap"},
    // below is there since t = 10 when left drives by.
    {"HitsAParkedRobot",
     [](Scene& s, Plan& p) {
       s.robots[1].goal = {-2, 4};
       replace(p, 0, {{0, {-4, 4}}, {20, {-4, 4}}, {28, {4, 4}}});
       replace(p, 1, {{0, {-2, -4}}, {8, {-2, 4}}});
     },
     Kind::kRobots,
     {"left", "below"},
     21.5,
     "overlap"},
    {"MakespanUnderstated",
     [](Scene&, Plan& p) { p.makespan -= 0.1; },
     Kind::kCosts,
     {},
     8,
     "makespan"},
    {"CostUnderstated",
     [](Scene&, Plan& p) { p.sum_of_costs -= 0.1; },
     Kind::kCosts,
     {},
     8,
     "sum of costs"},
    {"TimestepsUnderstated",
     [](Scene&, Plan& p) { p.sum_of_costs_timesteps -= 1; },
     Kind::kCosts,
     {},
     8,
     "timesteps"},
};

class BrokenHallPlan : public testing::TestWithParam<Break> {};

TEST_P(BrokenHallPlan, IsRefutedForWhatIsWrongWithIt) {
  const auto scene = hall();
  Plan plan = hall_plan(*scene);
  GetParam().apply(*scene, plan);
  const Verdict verdict = verify(scene, plan);
  ASSERT_FALSE(verdict.proved());
  const Violation& violation = *verdict.violation;
  EXPECT_EQ(to_string(violation.kind), to_string(GetParam().kind)) << violation.text;
  EXPECT_EQ(violation.robots, GetParam().robots) << violation.text;
  EXPECT_THAT(violation.text, HasSubstr(GetParam().text));
  if (GetParam().time >= 0) {
    EXPECT_NEAR(violation.time, GetParam().time, 1e-3) << violation.text;
  }
}

INSTANTIATE_TEST_SUITE_P(Verifier, BrokenHallPlan, testing::ValuesIn(kBreaks),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Verifier, RefutesTimesThatDoNotIncrease) {
#ifndef NDEBUG
  GTEST_SKIP() << "with assertions on, Trajectory refuses such times itself";
#endif
  const auto scene = hall();
  for (const double second : {4.0, 3.0, std::numeric_limits<double>::infinity()}) {
    Plan plan = hall_plan(*scene);
    plan.robots[0].trajectory = path({{0, {-4, 4}}, {4, {0, 4}}, {second, {1, 4}}, {8, {4, 4}}});
    const Verdict verdict = verify(scene, plan);
    ASSERT_FALSE(verdict.proved());
    EXPECT_EQ(verdict.violation->kind, Kind::kForm) << words(verdict);
    EXPECT_THAT(verdict.violation->robots, ElementsAre("left"));
  }
}

TEST(Verifier, SaysWhereTwoRobotsCollideAndByHowMuch) {
  const auto scene = hall();
  scene->robots[1].goal = {-2, 4};
  const Plan plan = plan_of(*scene, {path({{0, {-4, 4}}, {20, {-4, 4}}, {28, {4, 4}}}),
                                     path({{0, {-2, -4}}, {8, {-2, 4}}})});
  const Verdict verdict = verify(scene, plan);
  ASSERT_FALSE(verdict.proved());
  EXPECT_NEAR(verdict.violation->gap, -0.4, 0.1);
  EXPECT_NEAR(verdict.violation->where.x(), -2, 0.4);
  EXPECT_NEAR(verdict.violation->where.y(), 4, 0.4);
}

TEST(Verifier, AClearanceShortByAMillimetreBetweenRobotsIsRefuted) {
  const auto scene = hall();
  scene->robots[1].goal = {-2, 3.5};  // 0.5 below left's path: exactly radii and clearance
  const auto plan_to = [&](double y) {
    scene->robots[1].goal[1] = y;
    return plan_of(*scene, {path({{0, {-4, 4}}, {20, {-4, 4}}, {28, {4, 4}}}),
                            path({{0, {-2, -4}}, {8, {-2, y}}})});
  };
  EXPECT_TRUE(verify(scene, plan_to(3.5 - 1e-6)).proved());
  const Verdict verdict = verify(scene, plan_to(3.501));
  ASSERT_FALSE(verdict.proved());
  EXPECT_EQ(verdict.violation->kind, Kind::kRobots);
  EXPECT_THAT(verdict.violation->text, HasSubstr("within 0.0990 m"));
}

TEST(Verifier, FindsTheEarliestOfSeveralViolations) {
  const auto scene = hall();
  // left: too fast from t = 4 on; below leaves the bounds from t = 1.8 on.
  const Plan plan = plan_of(*scene, {path({{0, {-4, 4}}, {4, {0, 4}}, {6, {4, 4}}}),
                                     path({{0, {-2, -4}}, {2, {-2, -5}}, {9, {-2, 2}}})});
  const Verdict verdict = verify(scene, plan);
  ASSERT_FALSE(verdict.proved());
  EXPECT_EQ(verdict.violation->kind, Kind::kBounds) << words(verdict);
  EXPECT_THAT(verdict.violation->robots, ElementsAre("below"));
}

// ---- Arms ----

TEST(Verifier, RefutesAnArmThatPassesThroughItself) {
  const auto scene = arm_cell();
  scene->robots[0].goal = {1.5, 2.6, 2.6};
  const Plan plan = plan_of(*scene, {path({{0, {0, 0.5, 0.5}}, {3, {1.5, 2.6, 2.6}}})});
  const Verdict verdict = verify(scene, plan);
  ASSERT_FALSE(verdict.proved());
  EXPECT_EQ(verdict.violation->kind, Kind::kSelf) << words(verdict);
  EXPECT_THAT(verdict.violation->text, HasSubstr("\"link1\""));
  EXPECT_THAT(verdict.violation->text, HasSubstr("\"link3\""));
}

TEST(Verifier, RefutesAJointBeyondItsLimit) {
  const auto scene = arm_cell();
  const Plan plan =
      plan_of(*scene, {path({{0, {0, 0.5, 0.5}}, {4, {3.2, 0.5, 0.5}}, {8, {1.5, -0.5, 0.5}}})});
  const Verdict verdict = verify(scene, plan);
  ASSERT_FALSE(verdict.proved());
  EXPECT_EQ(verdict.violation->kind, Kind::kLimit) << words(verdict);
  EXPECT_NEAR(verdict.violation->time, 3.75, 1e-6);
  EXPECT_THAT(verdict.violation->text, HasSubstr("\"joint1\""));
}

TEST(Verifier, RefutesAJointThatTurnsTooFast) {
  const auto scene = arm_cell();
  const Plan plan = plan_of(*scene, {path({{0, {0, 0.5, 0.5}}, {1.49, {1.5, -0.5, 0.5}}})});
  const Verdict verdict = verify(scene, plan);
  ASSERT_FALSE(verdict.proved());
  EXPECT_EQ(verdict.violation->kind, Kind::kSpeed) << words(verdict);
}

TEST(Verifier, RefutesAnArmThatSweepsThroughTheTable) {
  const auto scene = arm_cell();
  const Plan plan =
      plan_of(*scene, {path({{0, {0, 0.5, 0.5}}, {3, {-1.2, -0.5, 0.5}}, {7, {1.5, -0.5, 0.5}}})});
  const Verdict verdict = verify(scene, plan);
  ASSERT_FALSE(verdict.proved());
  EXPECT_EQ(verdict.violation->kind, Kind::kObstacle) << words(verdict);
  EXPECT_THAT(verdict.violation->text, HasSubstr("\"table\""));
}

// ---- Many robots ----

// Discs on a grid of 1 m cells that all move along their rows, the even ones first.
std::pair<std::shared_ptr<Scene>, Plan> crowd(int side) {
  auto scene = std::make_shared<Scene>();
  scene->name = "crowd";
  scene->planar = true;
  const auto agv = disk_model(0.3);
  std::vector<Trajectory> paths;
  for (int i = 0; i < side * side; ++i) {
    const double x = 2.0 * (i % side);
    const double y = i / side;
    scene->robots.push_back(robot("r" + std::to_string(i), agv, {x, y}, {x + 1, y}));
    std::vector<Waypoint> there_and_back{{0, {x, y}}};
    for (int k = 0; k < 49; ++k) {
      there_and_back.push_back({2.0 * k + 1, {x + 1, y}});
      there_and_back.push_back({2.0 * k + 2, {x, y}});
    }
    there_and_back.push_back({99, {x + 1, y}});
    paths.push_back(path(there_and_back));
  }
  Plan plan = plan_of(*scene, std::move(paths));
  return {std::move(scene), std::move(plan)};
}

TEST(Verifier, SaysTheSameForAnyNumberOfThreads) {
  auto [scene, plan] = crowd(8);
  const Verdict one = verify(scene, plan, 1);
  const Verdict four = verify(scene, plan, 4);
  ASSERT_TRUE(one.proved()) << words(one);
  ASSERT_TRUE(four.proved()) << words(four);
  ASSERT_TRUE(one.robots && four.robots);
  EXPECT_EQ(one.robots->distance, four.robots->distance);
  EXPECT_EQ(one.robots->time, four.robots->time);
  EXPECT_EQ(one.robots->second, four.robots->second);

  // Several pairs collide; the earliest is named every time.
  for (const std::size_t lazy : {9U, 30U, 50U}) {
    Trajectory late(2);
    const double wait = 4.5 + static_cast<double>(lazy) / 4;
    late.append(0, scene->robots[lazy].start);
    late.append(wait, scene->robots[lazy].start);
    const Configuration aside{scene->robots[lazy].start[0] - 1, scene->robots[lazy].start[1]};
    late.append(wait + 1, aside);
    late.append(wait + 3, scene->robots[lazy].goal);
    plan.robots[lazy].trajectory = late;
  }
  const Verdict first = verify(scene, plan, 1);
  ASSERT_FALSE(first.proved());
  for (const unsigned threads : {2U, 3U, 8U}) {
    EXPECT_EQ(words(verify(scene, plan, threads)), words(first));
  }
}

TEST(Verifier, ProvesAThousandRobotsAtOnce) {
  const auto [scene, plan] = crowd(32);
  const auto begin = std::chrono::steady_clock::now();
  const Verdict verdict = verify(scene, plan, 2);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_TRUE(verdict.proved()) << words(verdict);
  RecordProperty("seconds", std::to_string(took.count()));
}

}  // namespace
}  // namespace accord
