// Colours that tell robots apart.
#pragma once

#include <cstddef>
#include <string>

namespace accord {

// "#rrggbb" of the index-th robot; neighbours differ clearly, however many there are.
std::string robot_colour(std::size_t index);

}  // namespace accord
