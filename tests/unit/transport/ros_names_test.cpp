#include "common/transport/ros/ros_names.h"

#include <gtest/gtest.h>

namespace accord {
namespace {

using Names = std::vector<std::string>;

TEST(RosNames, AreWhatRosTakes) {
  for (const char* name : {"accord", "accord/hall_4", "a1", "_a"}) {
    EXPECT_TRUE(is_ros_name(name)) << name;
  }
  for (const char* name :
       {"", "/accord", "accord/", "a//b", "4a", "a-b", "a__b", "a b", "\xC3\xA4"}) {
    EXPECT_FALSE(is_ros_name(name)) << name;
  }
  EXPECT_FALSE(is_ros_name(std::string(129, 'a')));
}

TEST(RosNames, OfRobotsAreTheirsAsFarAsMayBe) {
  EXPECT_EQ(ros_tokens({"agv_1", "agv-2", "7", "hall 4: lift", "", "*", "caf\xC3\xA9"}),
            (Names{"agv_1", "agv_2", "robot_7", "hall_4_lift", "robot", "robot_2", "caf"}));
}

TEST(RosNames, OfTwoRobotsAreNotTheSame) {
  EXPECT_EQ(ros_tokens({"a b", "a_b", "a-b", "a_b_2"}),
            (Names{"a_b", "a_b_2", "a_b_3", "a_b_2_2"}));
}

TEST(RosNames, OfAllRobotsMayBePartOfATopic) {
  for (const std::string& token : ros_tokens({std::string(200, 'x'), "__", "1__2", "_"})) {
    EXPECT_TRUE(is_ros_name("accord/" + token)) << token;
  }
}

}  // namespace
}  // namespace accord
