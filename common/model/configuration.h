// A configuration: one number per degree of freedom, in the order of the robot's kind
// (formats.md): disk x y, footprint x y heading, ball x y z, arm its movable joints.
#pragma once

#include <span>
#include <vector>

namespace accord {

using Configuration = std::vector<double>;  // owns its numbers
using ConfigurationView = std::span<const double>;

}  // namespace accord
