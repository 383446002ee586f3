#include "common/model/robot.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/scenes.h"

namespace accord {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

TEST(LeastDuration, BoundsTheNormOfTranslationsAndEachTurnOnItsOwn) {
  const auto cart = testing::cart_model(1, 1, /*speed=*/2, /*turn=*/0.5);
  EXPECT_NEAR(least_duration(*cart, Configuration{3, 4, 0}), 2.5, 1e-5);
  EXPECT_NEAR(least_duration(*cart, Configuration{3, 4, 2}), 4, 1e-5);
  EXPECT_GT(least_duration(*cart, Configuration{3, 4, 0}), 2.5);
}

TEST(Difference, TakesHeadingsTheShorterWayRound) {
  const auto cart = testing::cart_model(1, 1);
  Configuration out(3);
  difference(*cart, Configuration{0, 0, 3.0}, Configuration{1, 0, -3.0}, out);
  EXPECT_DOUBLE_EQ(out[0], 1);
  EXPECT_NEAR(out[2], kTurn - 6, 1e-12);
}

TEST(NearestRepresentation, MovesHeadingsByWholeTurnsAndLeavesTheRestAsItIs) {
  const auto cart = testing::cart_model(1, 1);
  Configuration out(3);
  nearest_representation(*cart, Configuration{0, 0, 7.0}, Configuration{100, 0, 0.5}, out);
  EXPECT_EQ(out[0], 100);
  EXPECT_NEAR(out[2], 0.5 + kTurn, 1e-12);
  nearest_representation(*cart, Configuration{0, 0, 0.1}, Configuration{0, 0, 0.3}, out);
  EXPECT_EQ(out[2], 0.3);  // to the bit: nothing was added and taken off again
}

}  // namespace
}  // namespace accord
