// Rows in columns under their headings. Pure; thread safe.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "client/watch/row.h"

namespace accord {

inline constexpr std::size_t kAnyWidth = std::numeric_limits<std::size_t>::max();

// A heading and a line for each row, of at most `width` characters: where they would be longer,
// texts are cut first, the longest first. Texts begin, numbers end at their column's edge; columns
// of nothing but empty texts are left out. Nothing where there are no rows. Requires: all rows have
// the same fields.
std::vector<std::string> in_columns(const std::vector<Row>& rows, std::size_t width = kAnyWidth);

}  // namespace accord
