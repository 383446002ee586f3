#include "common/io/grid.h"

#include <gtest/gtest.h>

#include <random>

namespace accord {
namespace {

Grid random_grid(std::size_t width, std::size_t height, double density, unsigned seed) {
  Grid grid{width, height, std::vector<std::uint8_t>(width * height)};
  std::mt19937 random(seed);
  std::bernoulli_distribution blocked(density);
  for (auto& cell : grid.blocked) cell = blocked(random) ? 1 : 0;
  return grid;
}

TEST(Cover, IsOneBlockForARectangle) {
  Grid grid{6, 5, std::vector<std::uint8_t>(30)};
  for (std::size_t y = 1; y <= 3; ++y) {
    for (std::size_t x = 2; x <= 4; ++x) grid.blocked[y * 6 + x] = 1;
  }
  EXPECT_EQ(cover(grid, 10), (std::vector<CellBlock>{{2, 4, 1, 3}}));
}

TEST(Cover, HoldsEveryBlockedCellOnceAndNoFreeOne) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Grid grid = random_grid(1 + seed % 17, 1 + seed % 13, 0.1 + 0.016 * seed, seed);
    std::vector<int> times(grid.blocked.size());
    const auto blocks = cover(grid, 1000);
    ASSERT_TRUE(blocks);
    for (const CellBlock& block : *blocks) {
      for (std::size_t y = block.first_row; y <= block.last_row; ++y) {
        for (std::size_t x = block.first_column; x <= block.last_column; ++x) {
          ++times[y * grid.width + x];
        }
      }
    }
    for (std::size_t i = 0; i < times.size(); ++i) ASSERT_EQ(times[i], grid.blocked[i]);
  }
}

TEST(Cover, GivesUpAtItsLimit) {
  const Grid grid{3, 1, {1, 0, 1}};
  EXPECT_TRUE(cover(grid, 2).has_value());
  EXPECT_EQ(cover(grid, 1), std::nullopt);
}

}  // namespace
}  // namespace accord
