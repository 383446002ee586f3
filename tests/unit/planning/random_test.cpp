#include "common/planning/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace accord {
namespace {

TEST(RandomStream, GivesTheSameNumbersOnEveryMachine) {
  RandomStream stream(42);
  const std::uint64_t first = stream.next(), second = stream.next();
  RandomStream again(42);
  EXPECT_EQ(again.next(), first);
  EXPECT_EQ(again.next(), second);
  EXPECT_NE(RandomStream(43).next(), first);
}

TEST(RandomStream, IsUniformEnough) {
  RandomStream stream(1);
  std::vector<int> bins(10, 0);
  for (int i = 0; i < 10000; ++i) ++bins[static_cast<std::size_t>(stream.uniform() * 10)];
  for (const int count : bins) EXPECT_NEAR(count, 1000, 150);
}

TEST(Combine, TellsOrderAndLengthApart) {
  EXPECT_NE(combine({1, 2}), combine({2, 1}));
  EXPECT_NE(combine({1}), combine({1, 0}));
}

TEST(Halton, FillsTheSquareEvenlyFromTheFirstPointsOn) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    std::vector<int> cells(16, 0);
    for (std::uint64_t i = 0; i < 160; ++i) {
      const auto x = static_cast<std::size_t>(halton(i, 0, seed) * 4);
      const auto y = static_cast<std::size_t>(halton(i, 1, seed) * 4);
      ASSERT_LT(x, 4u);
      ASSERT_LT(y, 4u);
      ++cells[4 * y + x];
    }
    for (const int count : cells) EXPECT_NEAR(count, 10, 5);
  }
}

TEST(Halton, StaysInTheUnitIntervalInAnyDimension) {
  for (std::size_t dimension = 0; dimension < 40; ++dimension) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      const double x = halton(i, dimension, 9);
      EXPECT_GE(x, 0);
      EXPECT_LT(x, 1);
    }
  }
}

}  // namespace
}  // namespace accord
