#include "coordinator/adaptation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "common/geometry/tolerances.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

class AdaptationTest : public ::testing::Test {
 protected:
  // Two discs that meet head on, and one that passes close by.
  void build_pair(bool with_passer_by) {
    testing::SceneBuilder builder(-50, -50, 50, 50);
    builder.disk(0.5, {-5, 0}, {5, 0}).disk(0.5, {5, 0}, {-5, 0});
    if (with_passer_by) builder.disk(0.5, {-5, 2}, {5, 2});
    build(builder);
  }

  // Discs that all want to cross the same place at the same time.
  void build_crowd(int robots = 8, double radius = 5) {
    testing::SceneBuilder builder(-70, -70, 70, 70);
    for (int i = 0; i < robots; ++i) {
      const double angle = 2 * std::numbers::pi * i / robots;
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      builder.disk(0.5, {x, y}, {-x, -y});
    }
    build(builder);
  }

  void build(const testing::SceneBuilder& builder) {
    scene_ = builder.build();
    world_.emplace(scene_, kPlanningMargin);
    schedule_.emplace(scene_);
    for (std::uint32_t id = 0; id < scene_->robots.size(); ++id) {
      const Robot& robot = scene_->robot({id});
      const double length = std::hypot(robot.goal[0] - robot.start[0],  //
                                       robot.goal[1] - robot.start[1]);
      schedule_->set_initial({id}, testing::path({{0, robot.start}, {length, robot.goal}}), "own");
    }
    board_.emplace(*world_, *schedule_);
    board_->look_at_all();
    factory_.emplace(*world_, 1);
    adaptation_.emplace(*factory_, *schedule_);
  }

  Conflict first() const { return *board_->conflicts().begin(); }
  Growth growth() const { return adaptation_->growth_of(first(), *board_); }
  Subproblem subproblem() const { return factory_->create(first(), growth(), *schedule_, *board_); }
  bool grow() { return adaptation_->grow(first(), subproblem(), {}, *board_); }

  // A resolution that delays the first robot by so much.
  static Resolution delayed(const Subproblem& subproblem, double delay) {
    Resolution out;
    out.solved = true;
    for (const Task& task : subproblem.tasks) {
      Trajectory path(task.goal.size());
      path.append(subproblem.from, task.start);
      path.append(task.to + (out.paths.empty() ? delay : 0), task.goal);
      out.paths.push_back(std::move(path));
    }
    return out;
  }

  std::shared_ptr<const Scene> scene_;
  std::optional<CollisionWorld> world_;
  std::optional<Schedule> schedule_;
  std::optional<ConflictBoard> board_;
  std::optional<SubproblemFactory> factory_;
  std::optional<Adaptation> adaptation_;
};

TEST_F(AdaptationTest, StartsWithThePairAlone) {
  build_pair(false);
  EXPECT_EQ(growth().taken_in, (std::set<RobotId>{{0}, {1}}));
  EXPECT_EQ(growth().window, 0u);
  EXPECT_FALSE(growth().crowd);
}

TEST_F(AdaptationTest, DoublesTheWindowOfAPairThatNobodyIsNear) {
  build_pair(false);
  const Subproblem before = subproblem();
  ASSERT_TRUE(grow());
  const Subproblem after = subproblem();
  EXPECT_LT(after.from, before.from);
  EXPECT_GT(after.to, before.to);
}

TEST_F(AdaptationTest, EndsWhenTheWholeProblemIsExhaustedAndNobodyElseIsThere) {
  build_pair(false);
  int grown = 0;
  while (grow()) ASSERT_LT(++grown, 20);
  EXPECT_TRUE(subproblem().whole);
}

// Another try often finds what one missed, and costs little next to the last one.
TEST_F(AdaptationTest, TriesTheWholeProblemAgainWithMoreSamplesBeforeItGoesToTheLimits) {
  build_pair(false);
  while (!subproblem().whole) ASSERT_TRUE(grow());
  Subproblem before = subproblem();
  EXPECT_EQ(before.limits.last_factor, 1U);
  for (unsigned retry = 1; retry <= Growth::kRetries; ++retry) {
    ASSERT_TRUE(grow());
    const Subproblem again = subproblem();
    EXPECT_NE(again.seed, before.seed);
    EXPECT_EQ(again.limits.decoupled_samples, 2 * before.limits.decoupled_samples);
    before = again;
  }
  EXPECT_GT(before.limits.last_factor, 1U);
  EXPECT_FALSE(grow());
}

TEST_F(AdaptationTest, LooksAheadLessBeforeItLooksAtMore) {
  build_pair(true);
  const Subproblem before = subproblem();
  ASSERT_FALSE(before.outsiders.empty());
  ASSERT_TRUE(grow());
  EXPECT_EQ(growth().window, 0u);
  EXPECT_LT(subproblem().horizon, before.horizon);
}

TEST_F(AdaptationTest, ForgetsHowFarAResolvedConflictHadGrown) {
  build_pair(false);
  ASSERT_TRUE(grow());
  adaptation_->note_resolved(first(), subproblem());
  EXPECT_EQ(growth().window, 0u);
}

TEST_F(AdaptationTest, GathersAllThatAreEntangledWhereALocalSolutionCostsMuch) {
  build_crowd();
  const Subproblem local = subproblem();
  ASSERT_EQ(local.tasks.size(), 2u);
  ASSERT_TRUE(adaptation_->prefers_crowd(first(), local, delayed(local, 10), *board_));
  const Growth crowd = growth();
  EXPECT_TRUE(crowd.crowd);
  EXPECT_EQ(crowd.taken_in.size(), 8u);
  EXPECT_TRUE(subproblem().is_crowd());
}

TEST_F(AdaptationTest, IsContentWithALocalSolutionThatCostsLittle) {
  build_crowd();
  const Subproblem local = subproblem();
  EXPECT_FALSE(adaptation_->prefers_crowd(first(), local, delayed(local, 0.1), *board_));
}

TEST_F(AdaptationTest, IsContentWithACostlySolutionWhereTooFewAreEntangled) {
  build_pair(false);
  const Subproblem local = subproblem();
  EXPECT_FALSE(adaptation_->prefers_crowd(first(), local, delayed(local, 10), *board_));
}

TEST_F(AdaptationTest, FallsBackToTheCostlyLocalSolutionWhereTheCrowdFails) {
  build_crowd();
  const Subproblem local = subproblem();
  ASSERT_TRUE(adaptation_->prefers_crowd(first(), local, delayed(local, 10), *board_));
  ASSERT_TRUE(grow());  // the crowd's subproblem was exhausted
  EXPECT_FALSE(growth().crowd);
  EXPECT_FALSE(adaptation_->prefers_crowd(first(), local, delayed(local, 10), *board_));
}

class LargeCrowd : public AdaptationTest {
 protected:
  LargeCrowd() {
    build_crowd(301, 60);
    const Subproblem local = subproblem();
    EXPECT_TRUE(adaptation_->prefers_crowd(first(), local, delayed(local, 10), *board_));
  }
};

TEST_F(LargeCrowd, MovesInLockstepToItsGoalsAndLooksOutForNobody) {
  const Subproblem all = subproblem();
  EXPECT_TRUE(all.lockstep);
  EXPECT_FALSE(all.is_crowd());
  EXPECT_EQ(all.tasks.size(), 301u);
  EXPECT_TRUE(all.outsiders.empty());
  for (const Task& task : all.tasks) EXPECT_EQ(task.goal, scene_->robot(task.robot).goal);
}

TEST_F(LargeCrowd, LooksAShortTimeAheadWhereLockstepHasFailed) {
  ASSERT_TRUE(grow());
  EXPECT_FALSE(subproblem().lockstep);
  EXPECT_TRUE(subproblem().is_crowd());
}

TEST_F(LargeCrowd, LeavesWhatLockstepHasLeftToTheLevels) {
  adaptation_->note_resolved(first(), subproblem());
  EXPECT_FALSE(subproblem().lockstep);
}

}  // namespace
}  // namespace accord
