// The partitions in which single robots hear of their own paths. Pure functions; thread safe.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace accord {

// CLUSTER/robot/NAME. Requires: has_partition(robot).
std::string robot_partition(std::string_view cluster, std::string_view robot);

// The robot whose partition it is; nullopt for what is no robot's of that cluster.
std::optional<std::string> robot_of_partition(std::string_view cluster, std::string_view partition);

// DDS takes partitions with '*', '?' and '[' for patterns: robots whose names have one of these
// have no partition of their own.
bool has_partition(std::string_view robot);

}  // namespace accord
