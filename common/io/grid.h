// Occupancy grids and the boxes that cover them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace accord {

// Row 0 is the lowest (smallest y), column 0 the leftmost.
struct Grid {
  std::size_t width = 0;  // cells
  std::size_t height = 0;
  std::vector<std::uint8_t> blocked;  // row by row; 0: free

  bool at(std::size_t column, std::size_t row) const { return blocked[row * width + column] != 0; }
};

// A block of cells, last column and row included.
struct CellBlock {
  std::size_t first_column;
  std::size_t last_column;
  std::size_t first_row;
  std::size_t last_row;

  friend bool operator==(const CellBlock&, const CellBlock&) = default;
};

// Blocks that cover exactly the blocked cells, none twice: greedily, each as wide as it can be and
// then as high. nullopt where more than `max_blocks` would be needed.
std::optional<std::vector<CellBlock>> cover(const Grid& grid, std::size_t max_blocks);

}  // namespace accord
