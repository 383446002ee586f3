#include "common/model/plan.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace accord {
namespace {

TEST(PlanCosts, SumArrivalsAndCountTimestepsRoundedUp) {
  Plan plan;
  plan.timestep = 0.1;
  plan.robots.push_back({"a", testing::path({{0, {0}}, {1.01, {1}}, {5, {1}}}), {}});
  plan.robots.push_back({"b", testing::path({{0, {0}}, {0.3, {1}}}), {}});
  compute_costs(plan);
  EXPECT_DOUBLE_EQ(plan.makespan, 1.01);
  EXPECT_DOUBLE_EQ(plan.sum_of_costs, 1.31);
  EXPECT_EQ(plan.sum_of_costs_timesteps, 11 + 3);  // 0.3 / 0.1 is 3, whatever doubles say
}

}  // namespace
}  // namespace accord
