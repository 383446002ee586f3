// MovingAI grid maps (movingai.com/benchmarks): four header lines, then a character a cell.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/io/diagnostic.h"
#include "common/io/grid.h"

namespace accord {

// Cells '.' and 'G' are free, '@', 'O', 'T', 'S' and 'W' blocked; the first row is the topmost.
// Anything else is reported with its line, all lines up to kLineFaults. Thread safe.
std::optional<Grid> parse_movingai_map(std::string_view text, const std::string& file,
                                       Faults& faults);

}  // namespace accord
