#include "common/model/trajectory.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace accord {
namespace {

using testing::path;

TEST(Trajectory, IsLinearBetweenWaypointsAndParkedOutside) {
  const Trajectory p = path({{1, {0, 0}}, {3, {4, 2}}});
  EXPECT_EQ(p.at(0.0), Configuration({0, 0}));
  EXPECT_EQ(p.at(2.0), Configuration({2, 1}));
  EXPECT_EQ(p.at(3.0), Configuration({4, 2}));
  EXPECT_EQ(p.at(99.0), Configuration({4, 2}));
}

TEST(Trajectory, ArrivesWhereItsLastConfigurationIsFirstHeldForGood) {
  EXPECT_EQ(path({{0, {0}}, {1, {5}}, {2, {5}}, {9, {5}}}).arrival_time(), 1);
  EXPECT_EQ(path({{0, {5}}, {1, {6}}, {2, {5}}}).arrival_time(), 2);
  EXPECT_EQ(path({{0, {5}}, {7, {5}}}).arrival_time(), 0);
}

TEST(Trajectory, TidyingDropsWhatAddsNothingAndKeepsEveryMotionAndWait) {
  const Trajectory p = path({{0, {0}}, {1, {0}}, {2, {0}}, {3, {1}}, {4, {1}}});
  EXPECT_EQ(p.tidied(), path({{0, {0}}, {2, {0}}, {3, {1}}}));
}

}  // namespace
}  // namespace accord
