#include "common/transport/fleet/robot_partition.h"

#include "common/io/limits.h"

namespace accord {
namespace {

constexpr std::string_view kMiddle = "/robot/";

}  // namespace

bool has_partition(std::string_view robot) {
  return !robot.empty() && robot.size() <= limits::kNameBytes &&
         robot.find_first_of("*?[]") == std::string_view::npos;
}

std::string robot_partition(std::string_view cluster, std::string_view robot) {
  return std::string(cluster) + std::string(kMiddle) + std::string(robot);
}

std::optional<std::string> robot_of_partition(std::string_view cluster,
                                              std::string_view partition) {
  if (!partition.starts_with(cluster)) return std::nullopt;
  partition.remove_prefix(cluster.size());
  if (!partition.starts_with(kMiddle)) return std::nullopt;
  partition.remove_prefix(kMiddle.size());
  if (!has_partition(partition)) return std::nullopt;
  return std::string(partition);
}

}  // namespace accord
