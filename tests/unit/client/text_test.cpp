#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/plan_text.h"
#include "client/table.h"
#include "tests/unit/planning/verifier_scenes.h"

namespace accord {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Table, PadsNamesToOneWidth) {
  Table table;
  table.add("a", "1");
  table.add("longer", "2");
  EXPECT_EQ(table.str(), "a       1\nlonger  2\n");
}

TEST(PlanText, SaysWhatWasCountedAndNothingElse) {
  Plan plan;
  plan.status = PlanStatus::kSolved;
  plan.sum_of_costs = 110;
  plan.statistics = {
      {"lower_bound", 100}, {"solved_by_prioritized-query", 7}, {"solved_by_composite-prm", 0}};
  Verdict verdict;
  verdict.robots = Separation{0.15, 3, "a", "b"};
  const std::string text = solved_text(*hall(), plan, verdict);
  EXPECT_THAT(text, HasSubstr("10.0 % above"));
  EXPECT_THAT(text, HasSubstr("prioritized-query 7\n"));
  EXPECT_THAT(text, HasSubstr("at least 0.1500 m, a and b at t = 3.00 s"));
  EXPECT_THAT(text, Not(HasSubstr("composite-prm")));
}

// A solved plan's line of that name.
std::string line_of(const std::string& name, const Plan& plan, const Verdict& verdict = {}) {
  const std::string text = solved_text(*hall(), plan, verdict);
  const std::size_t begin = text.find(name);
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(PlanText, CountsConflictsAndResolutionsApart) {
  Plan plan;
  plan.statistics = {{"conflicts_found", 24}, {"conflicts_resolved", 7}, {"rounds", 5}};
  EXPECT_THAT(line_of("conflicts", plan), HasSubstr("24 found, 7 resolutions in 5 rounds"));
  plan.statistics = {{"conflicts_found", 1}, {"conflicts_resolved", 1}, {"rounds", 1}};
  EXPECT_THAT(line_of("conflicts", plan), HasSubstr("1 found, 1 resolution in 1 round"));
  plan.statistics = {{"conflicts_found", 0}, {"conflicts_resolved", 0}, {"rounds", 1}};
  EXPECT_THAT(line_of("conflicts", plan), testing::EndsWith("  none"));
}

// hall() keeps 0.1 m; "at least 0.1000 m" or less would look as if it might not.
TEST(Separations, BelowWhatIsShownAreSaidToBeAboveTheClearance) {
  Verdict verdict;
  verdict.obstacles = Separation{0.10004, 3, "a", "wall"};
  EXPECT_THAT(line_of("to obstacles", {}, verdict),
              HasSubstr("more than the clearance of 0.1 m, a and wall at t = 3.00 s"));
  verdict.obstacles->distance = 0.1;
  EXPECT_THAT(line_of("to obstacles", {}, verdict), HasSubstr("more than the clearance"));
}

TEST(Separations, AreRoundedDownForTheyAreLowerBounds) {
  Verdict verdict;
  verdict.robots = Separation{0.12349, 3, "a", "b"};
  EXPECT_THAT(line_of("between robots", {}, verdict), HasSubstr("at least 0.1234 m"));
  verdict.robots->distance = 0.29;
  EXPECT_THAT(line_of("between robots", {}, verdict), HasSubstr("at least 0.2900 m"));
}

TEST(Separations, FromAMetreOnAreOfNoInterest) {
  EXPECT_THAT(line_of("between robots", {}), HasSubstr("1 m or more"));
}

TEST(PlanText, OfAFailureNamesItAndSaysWhy) {
  Plan plan;
  plan.status = PlanStatus::kInfeasible;
  plan.message = "\"a\" cannot reach its goal";
  EXPECT_EQ(unsolved_text(plan), "infeasible: \"a\" cannot reach its goal\n");
}

}  // namespace
}  // namespace accord
