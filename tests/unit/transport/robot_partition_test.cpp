#include "common/transport/fleet/robot_partition.h"

#include <gtest/gtest.h>

namespace accord {
namespace {

TEST(RobotPartition, IsTheClustersWithTheRobotsName) {
  EXPECT_EQ(robot_partition("default", "agv 7"), "default/robot/agv 7");
  for (const char* robot : {"agv 7", "a/b", "robot", "\xC3\xA4"}) {
    EXPECT_EQ(robot_of_partition("c", robot_partition("c", robot)), robot);
  }
}

TEST(RobotPartition, IsNobodysInAnotherClusterOrForm) {
  for (const char* partition : {"default", "default/robot/", "default/robots/a", "other/robot/a",
                                "default2/robot/a", "defaul", "", "*", "default/*"}) {
    EXPECT_EQ(robot_of_partition("default", partition), std::nullopt) << partition;
  }
}

// DDS would take it for a pattern.
TEST(RobotPartition, IsNotForNamesWithWildcards) {
  for (const char* robot : {"", "a*", "?", "a[1]", "]"}) {
    EXPECT_FALSE(has_partition(robot)) << robot;
    EXPECT_EQ(robot_of_partition("c", robot_partition("c", robot)), std::nullopt);
  }
  EXPECT_FALSE(has_partition(std::string(1000, 'a')));
}

}  // namespace
}  // namespace accord
