#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "common/planning/verifier.h"
#include "tests/unit/planning/verifier_scenes.h"

namespace accord {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string words(const Verdict& verdict) {
  return verdict.violation ? verdict.violation->text : "proved";
}

// hall_plan() with segments as the planner writes them; the paths end at t = 8 and 7.
Plan segmented_plan(const Scene& scene) {
  Plan plan = hall_plan(scene);
  plan.robots[0].segments = {{0, 3, {"left"}, "prm"},
                             {3, 6, {"left", "below"}, "prioritized-query"},
                             {6, 8, {"left"}, "prm"}};
  plan.robots[1].segments = {{0, 7, {"left", "below"}, "prioritized-query"}};
  return plan;
}

TEST(VerifierSegments, AreProvedWhereTheyCoverThePaths) {
  const auto scene = hall();
  const Verdict verdict = verify(scene, segmented_plan(*scene));
  EXPECT_TRUE(verdict.proved()) << words(verdict);
}

TEST(VerifierSegments, MayBeMissingForSomeRobots) {
  const auto scene = hall();
  Plan plan = segmented_plan(*scene);
  plan.robots[1].segments.clear();
  EXPECT_TRUE(verify(scene, plan).proved()) << words(verify(scene, plan));
}

TEST(VerifierSegments, OfARobotThatNeverMovesHaveNoLength) {
  const auto scene = hall();
  for (Robot& robot : scene->robots) robot.goal = robot.start;
  Plan plan = plan_of(*scene, {path({{0, {-4, 4}}}), path({{0, {-2, -4}}})});
  plan.robots[0].segments = {{0, 0, {"left"}, "prm"}};
  EXPECT_TRUE(verify(scene, plan).proved()) << words(verify(scene, plan));
}

TEST(VerifierSegments, MayBeRoundedByWhoeverWroteThem) {
  const auto scene = hall();
  Plan plan = segmented_plan(*scene);
  plan.robots[0].segments[0].to = 3 + 1e-12;
  EXPECT_TRUE(verify(scene, plan).proved()) << words(verify(scene, plan));
}

struct Break {
  const char* name;
  std::function<void(std::vector<PlanSegment>&)> apply;  // to the segments of "left"
  const char* text;
};

const Break kBreaks[] = {
    {"BeginLate", [](auto& s) { s[0].from = 1; },
     "segment 0: it begins at t = 1.000 s, not at t = 0"},
    {"BeginBeforeTime", [](auto& s) { s[0].from = -1; }, "segment 0: it begins at t = -1.000 s"},
    {"LeaveAGap", [](auto& s) { s[1].from = 3.5; },
     "segment 1: it begins at t = 3.500 s; the one before it ends at t = 3.000 s"},
    {"Overlap", [](auto& s) { s[1].from = 2.5; }, "segment 1: it begins at t = 2.500 s"},
    {"AreOutOfOrder", [](auto& s) { std::swap(s[0], s[1]); }, "segment 0: it begins at t = 3"},
    {"RunBackwards",
     [](auto& s) {
       s[0].to = 9;
       s[1] = {9, 6, {"left"}, "prm"};
     },
     "segment 1: it ends at t = 6.000 s, before it begins"},
    {"EndEarly", [](auto& s) { s.pop_back(); },
     "segment 1: the last ends at t = 6.000 s; the last waypoint is at t = 8.000 s"},
    {"EndLate", [](auto& s) { s[2].to = 9; }, "the last ends at t = 9.000 s"},
    {"EndNever", [](auto& s) { s[2].to = std::numeric_limits<double>::infinity(); },
     "the last ends at"},
    {"AreNotANumber", [](auto& s) { s[1].from = std::nan(""); }, "segment 1: it begins at"},
    {"NameAStranger", [](auto& s) { s[1].robots[1] = "ghost"; },
     "segment 1: the scene has no robot \"ghost\""},
    {"NameARobotTwice", [](auto& s) { s[1].robots.push_back("below"); },
     "segment 1: it names \"below\" twice"},
    {"LeaveTheRobotOut", [](auto& s) { s[2].robots = {"below"}; },
     "segment 2: it does not name the robot itself"},
    {"NameNobody", [](auto& s) { s[2].robots.clear(); },
     "segment 2: it does not name the robot itself"},
};

class BrokenSegments : public testing::TestWithParam<Break> {};

TEST_P(BrokenSegments, AreRefutedAsAFaultOfForm) {
  const auto scene = hall();
  Plan plan = segmented_plan(*scene);
  GetParam().apply(plan.robots[0].segments);
  const Verdict verdict = verify(scene, plan);
  ASSERT_FALSE(verdict.proved());
  EXPECT_EQ(verdict.violation->kind, Violation::Kind::kForm) << words(verdict);
  EXPECT_THAT(verdict.violation->robots, ElementsAre("left"));
  EXPECT_THAT(verdict.violation->text, HasSubstr("\"left\", "));
  EXPECT_THAT(verdict.violation->text, HasSubstr(GetParam().text));
  EXPECT_TRUE(std::isfinite(verdict.violation->time));
}

INSTANTIATE_TEST_SUITE_P(VerifierSegments, BrokenSegments, testing::ValuesIn(kBreaks),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace accord
