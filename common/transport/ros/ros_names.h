// Names as ROS 2 has them. Pure functions; thread safe.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace accord {

// Letters, digits and '_', not beginning with a digit, nor with two '_' anywhere: part of a topic's
// name.
bool is_ros_token(std::string_view text);
// Such tokens with '/' between them; at most 128 bytes.
bool is_ros_name(std::string_view text);

// A token for each robot, in their order and no two the same: its name, with '_' for what ROS does
// not take, and a number behind it where another robot has that already.
std::vector<std::string> ros_tokens(const std::vector<std::string>& robots);

}  // namespace accord
