#include "common/geometry/convex_decomposition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using Loop = std::vector<Vec2>;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double area(const Loop& v) {
  double twice = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    twice += v[i].x() * v[(i + 1) % v.size()].y() - v[i].y() * v[(i + 1) % v.size()].x();
  }
  return twice / 2;
}

bool contains(const Loop& v, const Vec2& p) {  // by parity
  bool inside = false;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec2& a = v[i];
    const Vec2& b = v[(i + 1) % v.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside;
}

void expect_decomposed(const Loop& polygon, std::size_t most) {
  const auto pieces = convex_decomposition(polygon, most);
  double sum = 0;
  for (const Loop& piece : pieces) {
    ASSERT_GE(piece.size(), 3U);
    ASSERT_LE(piece.size(), most);
    for (std::size_t i = 0; i < piece.size(); ++i) {
      EXPECT_GT(turn(piece[i], piece[(i + 1) % piece.size()], piece[(i + 2) % piece.size()]), 0);
    }
    sum += area(piece);
  }
  EXPECT_NEAR(sum, area(polygon), 1e-9 * area(polygon));
  // The same points are inside. Areas agree, so it is enough that no inner point is missed.
  std::mt19937_64 random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec2 p(test_scenes::uniform(random, -2, 2), test_scenes::uniform(random, -2, 2));
    if (!contains(polygon, p)) continue;
    EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(),
                            [&](const Loop& piece) { return contains(piece, p); }));
  }
}

TEST(ConvexDecomposition, LeavesSmallConvexPolygonsWhole) {
  const auto pieces = convex_decomposition(test_scenes::rectangle(2, 1), 8);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size(), 4U);
}

TEST(ConvexDecomposition, CutsAnEllInTwo) {
  EXPECT_EQ(convex_decomposition(test_scenes::ell(), 8).size(), 2U);
  expect_decomposed(test_scenes::ell(), 8);
}

TEST(ConvexDecomposition, SplitsWhatHasTooManyVertices) {
  Loop circle;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * std::numbers::pi * i / 64;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  expect_decomposed(circle, 8);
  EXPECT_LE(convex_decomposition(circle, 8).size(), 16U);
}

TEST(ConvexDecomposition, DropsVerticesThatAddNothing) {
  const Loop polygon{{0, 0}, {0.5, 0}, {1, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}};
  const auto pieces = convex_decomposition(polygon, 8);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size(), 4U);
}

TEST(ConvexDecomposition, OfNothingIsNothing) {
  EXPECT_TRUE(convex_decomposition(Loop{{0, 0}, {1, 0}, {2, 0}}, 8).empty());
}

TEST(ConvexDecomposition, OfCombsStarsAndSpirals) {
  Loop comb{{0, 0}, {1.9, 0}, {1.9, 0.1}};
  for (int i = 9; i >= 0; --i) {
    comb.emplace_back(0.19 * i + 0.1, 0.1);
    comb.emplace_back(0.19 * i + 0.1, 1);
    comb.emplace_back(0.19 * i, 1);
    comb.emplace_back(0.19 * i, 0.1);
  }
  comb.pop_back();
  expect_decomposed(comb, 8);

  std::mt19937_64 random(4);
  for (int k = 0; k < 30; ++k) {  // star-shaped about the origin, so that they are simple
    Loop star;
    for (int i = 0; i < 40; ++i) {
      const double angle = 2 * std::numbers::pi * i / 40;
      const double r = test_scenes::uniform(random, 0.2, 1.8);
      star.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    expect_decomposed(star, 8);
  }

  Loop spiral;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.3 * i;
    spiral.emplace_back((0.2 + 0.025 * i) * std::cos(angle), (0.2 + 0.025 * i) * std::sin(angle));
  }
  for (int i = 59; i >= 0; --i) {
    const double angle = 0.3 * i;
    spiral.emplace_back((0.1 + 0.025 * i) * std::cos(angle), (0.1 + 0.025 * i) * std::sin(angle));
  }
  if (area(spiral) < 0) std::reverse(spiral.begin(), spiral.end());
  expect_decomposed(spiral, 8);
}

}  // namespace
}  // namespace accord
