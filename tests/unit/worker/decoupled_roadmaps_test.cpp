#include "worker/decoupled_roadmaps.h"

#include <gtest/gtest.h>

#include "common/geometry/tolerances.h"
#include "common/planning/region.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

class DecoupledRoadmapsTest : public ::testing::Test {
 protected:
  DecoupledRoadmapsTest()
      : world_(testing::SceneBuilder(-6, -6, 6, 6)
                   .box(-1, -6, 1, -1)
                   .disk(0.5, {-4, 0}, {4, 0})
                   .disk(0.5, {4, 3}, {-4, 3})
                   .build(),
               kPlanningMargin),
        workspace_(world_) {
    subproblem_.seed = 3;
    subproblem_.to = 8;
    for (std::uint32_t id = 0; id < 2; ++id) {
      const Robot& robot = world_.scene().robot({id});
      subproblem_.tasks.push_back({{id},
                                   1,
                                   robot.start,
                                   8,
                                   robot.goal,
                                   Region{{-5, -5}, {5, 5}},
                                   testing::path({{0, robot.start}, {8, robot.goal}}),
                                   {},
                                   -1});
    }
  }

  CollisionWorld world_;
  Workspace workspace_;
  Subproblem subproblem_;
};

TEST_F(DecoupledRoadmapsTest, BeginWithStartGoalAndGuide) {
  DecoupledRoadmaps roadmaps(workspace_, subproblem_);
  const LocalRoadmap& first = roadmaps.of(0);
  EXPECT_EQ(first.configuration(DecoupledRoadmaps::start(first))[0], -4);
  EXPECT_EQ(first.configuration(DecoupledRoadmaps::goal(first))[0], 4);
  EXPECT_GT(first.size(), 2u);  // places along the guide
  EXPECT_EQ(roadmaps.samples(), 0u);
}

TEST_F(DecoupledRoadmapsTest, GrowByFreeSamplesOfTheRegionForThoseAskedFor) {
  DecoupledRoadmaps roadmaps(workspace_, subproblem_);
  const std::size_t before = roadmaps.of(0).size();
  roadmaps.add_samples(20);
  const LocalRoadmap& first = roadmaps.of(0);
  ASSERT_EQ(first.size(), before + 20);
  EXPECT_EQ(roadmaps.samples(), 20u);
  for (auto node = static_cast<LocalRoadmap::Node>(before); node < first.size(); ++node) {
    const ConfigurationView q = first.configuration(node);
    EXPECT_TRUE(world_.is_free({0}, q));
    EXPECT_LE(std::max(std::abs(q[0]), std::abs(q[1])), 5);
    EXPECT_FALSE(first.edges(node).empty());
  }
}

TEST_F(DecoupledRoadmapsTest, OfTheSameSubproblemAreTheSameHoweverTheyAreAskedFor) {
  DecoupledRoadmaps at_once(workspace_, subproblem_), in_steps(workspace_, subproblem_);
  at_once.add_samples(30);
  in_steps.of(0);
  in_steps.add_samples(10);
  in_steps.of(0);
  in_steps.add_samples(20);
  const LocalRoadmap &a = at_once.of(0), &b = in_steps.of(0);
  ASSERT_EQ(a.size(), b.size());
  for (LocalRoadmap::Node node = 0; node < a.size(); ++node) {
    EXPECT_TRUE(std::ranges::equal(a.configuration(node), b.configuration(node)));
  }
}

TEST_F(DecoupledRoadmapsTest, StandOnTheRobotsOwnRoadmapWhereItWasPlannedOnOne) {
  subproblem_.tasks[0].roadmap_level = 0;
  DecoupledRoadmaps roadmaps(workspace_, subproblem_);
  EXPECT_EQ(roadmaps.of(0).first_own(), workspace_.roadmap({0}).level(0).size());
  EXPECT_EQ(roadmaps.of(1).first_own(), 0u);
}

TEST_F(DecoupledRoadmapsTest, StandOnRoadmapsWhereNothingIsLeftToGrow) {
  subproblem_.whole = true;
  DecoupledRoadmaps roadmaps(workspace_, subproblem_);
  EXPECT_GT(roadmaps.of(1).first_own(), 0u);
}

}  // namespace
}  // namespace accord
