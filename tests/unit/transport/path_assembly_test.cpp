// One robot's path comes together from its pieces, whatever happens to those.
#include "common/transport/fleet/path_assembly.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/planning/random.h"
#include "common/transport/fleet/plan_pieces.h"
#include "tests/contract/fleet_samples.h"

namespace accord {
namespace {

class OnePath : public testing::Test {
 protected:
  FinishedPlan plan_ = fleet_samples::plan_of("1", 2, 10'000);
  const RobotPlan& robot_ = plan_.plan.robots[1];
  std::vector<PathPiece> pieces_ = PlanPieces(plan_).of_robot(1);
  PathAssembly assembly_{robot_.name};
};

TEST_F(OnePath, IsTheRobotsOfThePlan) {
  ASSERT_GT(pieces_.size(), 2U);
  RandomStream random(1);
  for (int run = 0; run < 20; ++run) {
    for (std::size_t i = pieces_.size() - 1; i > 0; --i) {
      std::swap(pieces_[i], pieces_[random.below(i + 1)]);
    }
    std::optional<RobotPath> path;
    for (const PathPiece& piece : pieces_) {
      ASSERT_FALSE(path);
      if (&piece != &pieces_.back()) {
        EXPECT_FALSE(assembly_.add(piece)) << "twice is once";
      }
      path = assembly_.add(piece);
    }
    ASSERT_TRUE(path);
    EXPECT_EQ(path->id, "1");
    EXPECT_EQ(path->robot, robot_.name);
    EXPECT_EQ(path->trajectory, robot_.trajectory);
    EXPECT_EQ(path->segments.size(), robot_.segments.size());
  }
}

TEST_F(OnePath, IsOfOneRequest) {
  for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) EXPECT_FALSE(assembly_.add(pieces_[i]));
  PathPiece other = pieces_.back();
  other.id = "2";
  EXPECT_FALSE(assembly_.add(other));
  EXPECT_FALSE(assembly_.add(pieces_.back())) << "the first path is forgotten";
}

TEST_F(OnePath, IsNobodyElses) {
  for (const PathPiece& piece : PlanPieces(plan_).of_robot(0)) EXPECT_FALSE(assembly_.add(piece));
  EXPECT_GT(assembly_.malformed(), 0U);
}

TEST_F(OnePath, IsNoneWhereTimesDoNotAscend) {
  std::swap(pieces_[0].times[0], pieces_[0].times[1]);
  for (const PathPiece& piece : pieces_) EXPECT_FALSE(assembly_.add(piece));
  EXPECT_EQ(assembly_.malformed(), 1U);
}

}  // namespace
}  // namespace accord
