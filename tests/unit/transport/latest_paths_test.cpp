#include "common/transport/fleet/latest_paths.h"

#include <gtest/gtest.h>

#include "common/transport/fleet/fleet_limits.h"
#include "tests/contract/fleet_samples.h"

namespace accord {
namespace {

std::shared_ptr<const FinishedPlan> plan_of(const std::string& id, std::size_t robots = 2) {
  return std::make_shared<const FinishedPlan>(fleet_samples::plan_of(id, robots, 10));
}

const std::string& robot_name(const FinishedPlan& plan, std::size_t place) {
  return plan.plan.robots[place].name;
}

TEST(LatestPaths, AreThoseOfThePlanThatCameLast) {
  LatestPaths paths(1 << 20);
  const auto first = plan_of("first", 3), second = plan_of("second", 2);
  paths.add(first);
  paths.add(second);
  EXPECT_EQ(paths.of(robot_name(*first, 1)).plan, second);
  EXPECT_EQ(paths.of(robot_name(*first, 1)).robot, 1U);
  EXPECT_EQ(paths.of(robot_name(*first, 2)).plan, first) << "the second plan is not of that robot";
  EXPECT_EQ(paths.of("nobody").plan, nullptr);
}

TEST(LatestPaths, AreNotThoseOfAPlanThatIsSentAgain) {
  LatestPaths paths(1 << 20);
  const auto first = plan_of("first"), second = plan_of("second");
  paths.add(first);
  paths.add(second);
  paths.add(plan_of("first"));
  EXPECT_EQ(paths.of(robot_name(*first, 0)).plan, second);
}

TEST(LatestPaths, KeepNoMoreThanTheyMay) {
  const std::size_t bytes = memory_of(*plan_of("any"));
  LatestPaths paths(2 * bytes);
  paths.add(plan_of("large", 20));
  EXPECT_EQ(paths.of(robot_name(*plan_of("any"), 0)).plan, nullptr);
  const auto kept = plan_of("1");
  const std::weak_ptr<const FinishedPlan> gone = [&] {
    const auto oldest = plan_of("0");
    paths.add(oldest);
    return oldest;
  }();
  paths.add(kept);
  EXPECT_FALSE(gone.expired());
  paths.add(plan_of("2"));
  EXPECT_TRUE(gone.expired());
}

}  // namespace
}  // namespace accord
