// Texts that came over the network, for a terminal: names and reasons are whatever somebody sent.
// Pure; thread safe.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace accord {

// Printable ASCII, one column a byte: all else is escaped as \x1B, so that nothing moves the
// cursor, turns the direction of writing or takes another width than it seems to. Cut with "..."
// where longer than `most`, at least 3.
std::string terminal_text(std::string_view text, std::size_t most);

}  // namespace accord
