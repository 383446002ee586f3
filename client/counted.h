// Counts in words.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace accord {

// "1 round", "2 rounds".
inline std::string counted(std::uint64_t count, std::string_view what) {
  return std::to_string(count) + ' ' + std::string(what) + (count == 1 ? "" : "s");
}

}  // namespace accord
