#include "client/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace accord {

std::string Table::str() const {
  std::size_t width = 0;
  for (const auto& [name, value] : rows_) width = std::max(width, name.size());
  std::string out;
  for (const auto& [name, value] : rows_) out += fmt::format("{:<{}}  {}\n", name, width, value);
  return out;
}

}  // namespace accord
