// Portable graymaps: what ROS maps keep their cells in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/diagnostic.h"

namespace accord {

struct Graymap {
  std::size_t width;
  std::size_t height;
  unsigned max_value;                 // white
  std::vector<std::uint16_t> values;  // row by row, the topmost first
};

// Text (P2) or binary (P5, one or two bytes a value), comments included. Faults of the binary part
// have no line: whoever named the file is blamed for them, with its name. Thread safe.
std::optional<Graymap> parse_pgm(std::string_view bytes, const std::string& file,
                                 const Blame& blame, Faults& faults);

}  // namespace accord
