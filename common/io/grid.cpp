#include "common/io/grid.h"

#include <algorithm>

namespace accord {
namespace {

class Cover {
 public:
  explicit Cover(const Grid& grid) : grid_(grid), left_(grid.blocked) {}

  bool is_left(std::size_t column, std::size_t row) const {
    return left_[row * grid_.width + column] != 0;
  }

  // Takes the block whose lowest left cell is the given one, which must be left.
  CellBlock take(std::size_t column, std::size_t row) {
    std::size_t last_column = column;
    while (last_column + 1 < grid_.width && is_left(last_column + 1, row)) ++last_column;
    std::size_t last_row = row;
    while (last_row + 1 < grid_.height && all_left(column, last_column, last_row + 1)) ++last_row;
    for (std::size_t y = row; y <= last_row; ++y) {
      std::fill_n(cell(column, y), last_column - column + 1, std::uint8_t{0});
    }
    return {column, last_column, row, last_row};
  }

 private:
  std::vector<std::uint8_t>::iterator cell(std::size_t column, std::size_t row) {
    return left_.begin() + static_cast<std::ptrdiff_t>(row * grid_.width + column);
  }

  bool all_left(std::size_t first, std::size_t last, std::size_t row) {
    return std::all_of(cell(first, row), cell(last, row) + 1,
                       [](auto value) { return value != 0; });
  }

  const Grid& grid_;
  std::vector<std::uint8_t> left_;
};

}  // namespace

std::optional<std::vector<CellBlock>> cover(const Grid& grid, std::size_t max_blocks) {
  Cover cover(grid);
  std::vector<CellBlock> blocks;
  for (std::size_t row = 0; row < grid.height; ++row) {
    for (std::size_t column = 0; column < grid.width; ++column) {
      if (!cover.is_left(column, row)) continue;
      if (blocks.size() == max_blocks) return std::nullopt;
      blocks.push_back(cover.take(column, row));
    }
  }
  return blocks;
}

}  // namespace accord
