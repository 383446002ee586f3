#include "worker/prioritized_repair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/tolerances.h"
#include "common/planning/region.h"
#include "tests/support/scenes.h"
#include "tests/unit/worker/solver_contract.h"
#include "worker/workspace.h"

namespace accord {
namespace {

const std::atomic<bool> kGoOn{false};

class PrioritizedRepair : public ::testing::Test {
 protected:
  // Every robot on its straight way, from 0 s on.
  void team_of(std::shared_ptr<const Scene> scene) {
    world_.emplace(scene, kPlanningMargin);
    workspace_.emplace(*world_);
    subproblem_.seed = 3;
    for (std::uint32_t id = 0; id < scene->robots.size(); ++id) {
      const Robot& robot = scene->robot({id});
      const double length = std::hypot(robot.goal[0] - robot.start[0],  //
                                       robot.goal[1] - robot.start[1]);
      const Trajectory guide = testing::path({{0, robot.start}, {length, robot.goal}});
      subproblem_.tasks.push_back(
          {{id}, 1, robot.start, length, robot.goal, whole_region(*scene, {id}), guide, {}, 0});
      subproblem_.to = std::max(subproblem_.to, length);
    }
    subproblem_.horizon = 100;
  }

  Resolution repair() {
    DecoupledRoadmaps roadmaps(*workspace_, subproblem_);
    Effort effort;
    Resolution out = prioritized_repair(*world_, subproblem_, roadmaps, kGoOn, effort);
    out.effort = effort;
    return out;
  }

  std::string breach(const Resolution& resolution) const {
    return testing::contract_breach(*world_, subproblem_, resolution);
  }

  std::optional<CollisionWorld> world_;
  std::optional<Workspace> workspace_;
  Subproblem subproblem_;
};

std::shared_ptr<const Scene> circle_of_discs(int count, double radius) {
  testing::SceneBuilder builder(-10, -10, 10, 10);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    builder.disk(0.4, {x, y}, {-x, -y});
  }
  return builder.build();
}

TEST_F(PrioritizedRepair, BringsACircleOfRobotsToTheOppositeSides) {
  team_of(circle_of_discs(12, 6));
  const Resolution found = repair();
  ASSERT_TRUE(found.solved);
  EXPECT_EQ(breach(found), "");
}

TEST_F(PrioritizedRepair, LeavesThoseAloneThatNobodyMeets) {
  team_of(testing::SceneBuilder(-10, -10, 10, 10)
              .disk(0.4, {-5, 0}, {5, 0})
              .disk(0.4, {5, 0.1}, {-5, 0.1})
              .disk(0.4, {-5, 8}, {5, 8})
              .build());
  const Resolution found = repair();
  ASSERT_TRUE(found.solved);
  EXPECT_EQ(breach(found), "");
  EXPECT_EQ(found.paths[2], subproblem_.tasks[2].guide);
}

// The second is in a dead end that the first, planned before it, is about to close.
TEST_F(PrioritizedRepair, AsksARobotThatIsInTheOnlyWayToMakeWay) {
  team_of(testing::SceneBuilder(-8, -1, 4, 3)
              .box(-4, 0.6, 4, 3)
              .disk(0.5, {-3, 0}, {3, 0})
              .disk(0.5, {1.5, 0}, {-6, 0})
              .build());
  const Resolution found = repair();
  ASSERT_TRUE(found.solved);
  EXPECT_EQ(breach(found), "");
  EXPECT_NEAR(found.paths[1].end_time(), 7.5, 1e-3);
  EXPECT_GT(found.paths[0].end_time(), 8);
}

TEST_F(PrioritizedRepair, GivesUpWhereNobodyCanMakeWay) {
  team_of(testing::SceneBuilder(-6, -0.6, 6, 0.6)
              .disk(0.5, {-5, 0}, {5, 0})
              .disk(0.5, {0, 0}, {0.1, 0})
              .disk(0.5, {5, 0}, {-5, 0})
              .build());
  EXPECT_FALSE(repair().solved);
}

TEST_F(PrioritizedRepair, KeepsClearOfOutsiders) {
  team_of(circle_of_discs(8, 6));
  const Task passer_by = subproblem_.tasks.back();
  subproblem_.tasks.pop_back();
  subproblem_.outsiders.push_back({passer_by.robot, 1, passer_by.guide, 100});
  const Resolution found = repair();
  ASSERT_TRUE(found.solved);
  EXPECT_EQ(breach(found), "");
}

// What comes after clear_until is left to later, so that a crowd's search stays short.
TEST_F(PrioritizedRepair, CaresForNothingThatComesLater) {
  team_of(circle_of_discs(12, 6));
  subproblem_.clear_until = 4;  // before anybody is near the middle
  const Resolution found = repair();
  ASSERT_TRUE(found.solved);
  for (std::size_t i = 0; i < found.paths.size(); ++i) {
    EXPECT_EQ(found.paths[i], subproblem_.tasks[i].guide);
  }
}

}  // namespace
}  // namespace accord
