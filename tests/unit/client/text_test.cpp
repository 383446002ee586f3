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
  verdict.robots = Separation{0.05, 3, "a", "b"};
  const std::string text = solved_text(*hall(), plan, verdict);
  EXPECT_THAT(text, HasSubstr("10.0 % above"));
  EXPECT_THAT(text, HasSubstr("prioritized-query 7\n"));
  EXPECT_THAT(text, HasSubstr("at least 0.0500 m, a and b at t = 3.00 s"));
  EXPECT_THAT(text, Not(HasSubstr("composite-prm")));
}

TEST(PlanText, OfAFailureNamesItAndSaysWhy) {
  Plan plan;
  plan.status = PlanStatus::kInfeasible;
  plan.message = "\"a\" cannot reach its goal";
  EXPECT_EQ(unsolved_text(plan), "infeasible: \"a\" cannot reach its goal\n");
}

}  // namespace
}  // namespace accord
