#include "client/terminal_text.h"

#include <fmt/format.h>

namespace accord {

std::string terminal_text(std::string_view text, std::size_t most) {
  constexpr std::string_view kDots = "...";
  std::string out;
  std::size_t room_for_dots = 0;  // how much of `out` stays where it is cut
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const std::string shown =
        byte >= 0x20 && byte < 0x7F ? std::string(1, c) : fmt::format("\\x{:02X}", byte);
    if (out.size() + shown.size() > most) return out.substr(0, room_for_dots).append(kDots);
    out += shown;
    if (out.size() + kDots.size() <= most) room_for_dots = out.size();
  }
  return out;
}

}  // namespace accord
