#include "worker/local_roadmap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/geometry/tolerances.h"
#include "tests/support/scenes.h"
#include "worker/times_to_goal.h"

namespace accord {
namespace {

// A square of side 2 with an obstacle on its lower edge; nodes 0 to 3 go round it from (0, 0).
class SquareRoadmap : public ::testing::Test {
 protected:
  SquareRoadmap()
      : world_(testing::SceneBuilder(-2, -2, 4, 4)
                   .box(0.8, -0.2, 1.2, 0.2)
                   .disk(0.3, {0, 0}, {2, 2})
                   .build(),
               kPlanningMargin),
        team_(world_, {RobotId{0}}, 0),
        roadmap_(team_) {
    for (const Configuration& q :
         {Configuration{0, 0}, Configuration{2, 0}, Configuration{2, 2}, Configuration{0, 2}}) {
      roadmap_.add(team_, q);
    }
    for (LocalRoadmap::Node node = 0; node < 4; ++node) {
      roadmap_.connect(team_, node, (node + 1) % 4);
    }
  }

  // Durations are a little longer than distance over speed: see least_duration().
  void expect_times(const std::vector<double>& expected) {
    ASSERT_EQ(roadmap_.size(), expected.size());
    TimesToGoal times(team_, roadmap_, 1, 0);
    for (LocalRoadmap::Node node = 0; node < expected.size(); ++node) {
      if (std::isinf(expected[node])) {
        EXPECT_TRUE(std::isinf(times.from(node)));
      } else {
        EXPECT_NEAR(times.from(node), expected[node], 1e-5);
      }
    }
  }

  const LocalRoadmap::Edge& edge(LocalRoadmap::Node a, LocalRoadmap::Node b) const {
    for (const auto& edge : roadmap_.edges(a)) {
      if (edge.to == b) return edge;
    }
    throw std::logic_error("no such edge");
  }

  CollisionWorld world_;
  Team team_;
  LocalRoadmap roadmap_;
};

TEST_F(SquareRoadmap, TimesToAGoalAreTheShortestAlongItsEdges) {
  expect_times({2, 0, 2, 4});
}

TEST_F(SquareRoadmap, TimesToAGoalLeaveOutEdgesKnownToBeBlocked) {
  ASSERT_FALSE(roadmap_.is_free(team_, 0, edge(0, 1)));
  expect_times({6, 0, 2, 4});
}

TEST_F(SquareRoadmap, TimesToAGoalFollowTheRoadmapAsItGrows) {
  expect_times({2, 0, 2, 4});
  roadmap_.connect(team_, 1, 3);
  expect_times({2, 0, 2, std::sqrt(8)});
  roadmap_.add(team_, Configuration{3, 3});
  expect_times({2, 0, 2, std::sqrt(8), std::numeric_limits<double>::infinity()});
}

TEST_F(SquareRoadmap, APlaceThatIsThereAlreadyIsUsedAgain) {
  EXPECT_EQ(roadmap_.add(team_, Configuration{2, 2}), 2u);
  EXPECT_EQ(roadmap_.add(team_, Configuration{2, 2}, false), 4u);
}

}  // namespace
}  // namespace accord
