#include "common/io/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace accord {
namespace {

std::vector<Vec2> star(std::size_t points) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < points; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const double radius = i % 2 == 0 ? 2 : 1;
    out.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return out;
}

TEST(OutlineFault, AcceptsConvexAndNot) {
  EXPECT_EQ(outline_fault({{0, 0}, {1, 0}, {0, 1}}), std::nullopt);
  EXPECT_EQ(outline_fault({{0, 0}, {2, 0}, {2, 1}, {1, 0.2}, {0, 1}}), std::nullopt);
  EXPECT_EQ(outline_fault(star(100)), std::nullopt);
}

TEST(OutlineFault, AcceptsPointsOnStraightEdgesAndEitherDirection) {
  EXPECT_EQ(outline_fault({{0, 0}, {0.5, 0}, {1, 0}, {0, 1}}), std::nullopt);
  EXPECT_EQ(outline_fault({{0, 1}, {1, 0}, {0, 0}}), std::nullopt);
}

TEST(OutlineFault, FindsCrossingEdgesAmongMany) {
  std::vector<Vec2> points = star(100);
  std::swap(points[40], points[50]);
  EXPECT_TRUE(outline_fault(points).has_value());
}

TEST(OutlineFault, FindsOutlinesThatTouchThemselvesInAPoint) {
  // Two triangles that share a corner.
  EXPECT_TRUE(outline_fault({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}).has_value());
}

TEST(OutlineFault, FindsSpikes) {
  EXPECT_TRUE(outline_fault({{0, 0}, {1, 0}, {1, 1}, {1, 3}, {1, 1}, {0, 1}}).has_value());
  EXPECT_TRUE(outline_fault({{0, 0}, {3, 0}, {1, 0}, {1, 1}}).has_value());
}

TEST(OutlineFault, RefusesSliversThatRoundingWouldClose) {
  EXPECT_TRUE(outline_fault({{0, 0}, {1, 0}, {1, 1e-9}, {0, 1e-9}}).has_value());
  EXPECT_TRUE(outline_fault({{0, 0}, {1, 0}, {2, 1e-9}}).has_value());
}

}  // namespace
}  // namespace accord
