#include "common/io/plan_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace accord {
namespace {

Trajectory path(std::initializer_list<std::pair<double, Configuration>> waypoints) {
  Trajectory out(waypoints.begin()->second.size());
  for (const auto& [t, q] : waypoints) out.append(t, q);
  return out;
}

Plan two_carts() {
  Plan plan;
  plan.scene = "two-carts";
  plan.status = PlanStatus::kSolved;
  plan.planning_time = 0.0123;
  plan.robots = {{"a", path({{0, {0, 0}}, {4, {4, 0}}}), {{0, 4, {"a", "b"}, "decoupled-prm"}}},
                 {"b", path({{0, {1.5, -2}}}), {{0, 0, {"b"}, "prm"}}}};
  plan.statistics = {{"conflicts", 3}, {"search_time", 0.5}, {"queries", 1e9}};
  compute_costs(plan);
  return plan;
}

TEST(PlanFile, IsLaidOutAsTheFormatSays) {
  EXPECT_EQ(to_json(two_carts()), R"({
  "accord": "plan/1",
  "scene": "two-carts",
  "status": "solved",
  "message": "",
  "method": "arc",
  "seed": 1,
  "timestep": 0.1,
  "planning_time": 0.0123,
  "makespan": 4,
  "sum_of_costs": 4,
  "sum_of_costs_timesteps": 40,
  "robots": [
    {"name": "a",
     "waypoints": [
      {"t": 0, "q": [0, 0]},
      {"t": 4, "q": [4, 0]}],
     "segments": [
      {"from": 0, "to": 4, "robots": ["a", "b"], "solver": "decoupled-prm"}]},
    {"name": "b",
     "waypoints": [
      {"t": 0, "q": [1.5, -2]}],
     "segments": [
      {"from": 0, "to": 0, "robots": ["b"], "solver": "prm"}]}],
  "statistics": {
    "conflicts": 3,
    "search_time": 0.5,
    "queries": 1000000000
  }
}
)");
}

bool same(const Plan& a, const Plan& b) {
  if (a.robots.size() != b.robots.size()) return false;
  for (std::size_t i = 0; i < a.robots.size(); ++i) {
    if (a.robots[i].trajectory != b.robots[i].trajectory) return false;
  }
  return to_json(a) == to_json(b);
}

TEST(PlanFile, ReadsBackWhatItWrote) {
  const Plan plan = two_carts();
  const PlanResult result = parse_plan(to_json(plan), "p.json");
  for (const Diagnostic& fault : result.faults) ADD_FAILURE() << to_string(fault);
  ASSERT_TRUE(result.plan);
  EXPECT_TRUE(same(*result.plan, plan));
  EXPECT_EQ(result.plan->robots[0].segments[0].robots, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(result.plan->statistics, plan.statistics);
}

TEST(PlanFile, KeepsEveryNumberExactly) {
  std::mt19937_64 random(7);
  Plan plan = two_carts();
  Trajectory wild(3);
  double t = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto number = [&] {
      return std::ldexp(std::uniform_real_distribution<>(-1, 1)(random),
                        static_cast<int>(random() % 80) - 50);
    };
    wild.append(t, Configuration{number(), -0.0, number()});
    t = std::nextafter(t, 1e9) + std::abs(number()) * 1e-5;
  }
  plan.robots[0].trajectory = wild;
  plan.seed = std::numeric_limits<std::uint64_t>::max();
  const PlanResult result = parse_plan(to_json(plan), "p.json");
  ASSERT_TRUE(result.plan);
  EXPECT_TRUE(same(*result.plan, plan));
}

TEST(PlanFile, CarriesAnyNameAndMessage) {
  Plan plan;
  plan.status = PlanStatus::kInfeasible;
  plan.scene = "quote \" backslash \\ umlaut ü";
  plan.message = "tab\t and line\n";
  const PlanResult result = parse_plan(to_json(plan), "p.json");
  ASSERT_TRUE(result.plan);
  EXPECT_EQ(result.plan->scene, plan.scene);
  EXPECT_EQ(result.plan->message, plan.message);
  EXPECT_EQ(result.plan->status, PlanStatus::kInfeasible);
  plan.scene = "not UTF-8: \xFF";
  EXPECT_TRUE(parse_plan(to_json(plan), "p.json").plan.has_value());
}

TEST(CanonicalBytes, LeaveOutMeasuredTimesAndNothingElse) {
  Plan plan = two_carts();
  const std::string before = canonical_bytes(plan);
  plan.planning_time = 99;
  plan.statistics[1].second = 77;
  EXPECT_EQ(canonical_bytes(plan), before);
  plan.statistics[0].second = 4;
  EXPECT_NE(canonical_bytes(plan), before);
}

// The faults of the plan of two carts with one text replaced.
std::vector<std::string> faults_with(const std::string& part, const std::string& replacement) {
  std::string text = to_json(two_carts());
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  text.replace(at, part.size(), replacement);
  const PlanResult result = parse_plan(text, "p.json");
  EXPECT_EQ(result.plan.has_value(), result.faults.empty());
  std::vector<std::string> out;
  for (const Diagnostic& fault : result.faults) out.push_back(to_string(fault));
  return out;
}

using Lines = std::vector<std::string>;

TEST(PlanFile, ReportsFaultsWithLineAndKey) {
  EXPECT_EQ(faults_with("plan/1", "plan/2"),
            Lines{"p.json:2: accord: expected plan/1, not the string \"plan/2\""});
  EXPECT_EQ(faults_with("\"solved\"", "\"done\""),
            Lines{"p.json:4: status: expected solved, infeasible, timeout, cancelled or invalid, "
                  "not the string \"done\""});
  EXPECT_EQ(faults_with("\"seed\": 1,", "\"sed\": 1,"),
            Lines{"p.json:7: sed: unknown key in a plan; did you mean \"seed\"?"});
  EXPECT_EQ(faults_with("\"seed\": 1,", "\"seed\": -1,"),
            Lines{"p.json:7: seed: expected a whole number from 0, not \"-1\""});
  EXPECT_EQ(faults_with("{\"t\": 4, ", "{\"t\": 0, "),
            Lines{"p.json:17: robots[0].waypoints[1].t: times must increase, but 0 follows 0"});
  EXPECT_EQ(
      faults_with("[4, 0]", "[4, 0, 0]"),
      Lines{"p.json:17: robots[0].waypoints[1].q: expected 2 numbers as in the first waypoint, "
            "not 3"});
  EXPECT_EQ(faults_with("[4, 0]", "[4, null]"),
            Lines{"p.json:17: robots[0].waypoints[1].q[1]: expected a number, not nothing"});
  EXPECT_EQ(faults_with("[4, 0]", "[4, 1e999]"),
            Lines{"p.json:17: the number \"1e999\" is too large"});
  EXPECT_EQ(faults_with("\"from\": 0, \"to\": 4", "\"from\": 5, \"to\": 4"),
            Lines{"p.json:19: robots[0].segments[0].to: ends before it begins, at 5"});
  EXPECT_EQ(faults_with("\"timestep\": 0.1", "\"timestep\": 0"),
            Lines{"p.json:8: timestep: must be greater than 0 s, not 0"});
}

TEST(PlanFile, ReportsSeveralFaultsAtOnce) {
  EXPECT_EQ(
      faults_with("{\"t\": 0, \"q\": [0, 0]}", "{\"t\": \"0\", \"q\": [true, 0], \"v\": 1}").size(),
      3U);
}

TEST(PlanFile, PassesOverStatisticsThatAreNoNumbers) {
  EXPECT_EQ(faults_with("\"conflicts\": 3", "\"solvers\": {\"prm\": 3}, \"note\": \"x\""), Lines{});
}

TEST(PlanFile, SurvivesBeingCutAnywhere) {
  const std::string text = to_json(two_carts());
  for (std::size_t size = 0; size + 2 < text.size(); ++size) {
    const PlanResult result = parse_plan(std::string_view(text).substr(0, size), "p.json");
    ASSERT_FALSE(result.plan);
    ASSERT_EQ(result.faults.size(), 1U);
  }
}

}  // namespace
}  // namespace accord
