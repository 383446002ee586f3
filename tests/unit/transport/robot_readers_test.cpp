#include "common/transport/dds/fleet/robot_readers.h"

#include <gtest/gtest.h>

namespace accord::dds {
namespace {

using Names = std::set<std::string>;

RobotReaders::Guid reader(unsigned char participant, unsigned char entity) {
  RobotReaders::Guid guid;
  guid.guidPrefix.value[0] = participant;
  guid.entityId.value[3] = entity;
  return guid;
}

class RobotReadersTest : public ::testing::Test {
 protected:
  RobotReadersTest() {
    readers_.set_listener([this] { ++changes_; });
  }

  RobotReaders readers_{"default"};
  int changes_ = 0;
};

TEST_F(RobotReadersTest, AreThoseInPartitionsOfRobots) {
  readers_.found(reader(1, 1), {"default/robot/a", "default/robot/b"});
  readers_.found(reader(2, 1), {"default/robot/b"});
  EXPECT_EQ(changes_, 2);
  readers_.found(reader(3, 1), {"default"});
  readers_.found(reader(4, 1), {"other/robot/c", "*"});
  EXPECT_EQ(changes_, 2) << "they are of all robots' paths, or another cluster's";
  EXPECT_EQ(readers_.robots(), (Names{"a", "b"}));
}

TEST_F(RobotReadersTest, GoOneByOneOrWithTheirParticipants) {
  readers_.found(reader(1, 1), {"default/robot/a"});
  readers_.found(reader(1, 2), {"default/robot/b"});
  readers_.found(reader(2, 1), {"default/robot/b"});
  readers_.gone(reader(2, 1));
  EXPECT_EQ(readers_.robots(), (Names{"a", "b"}));
  readers_.gone(reader(1, 1).guidPrefix);
  EXPECT_EQ(readers_.robots(), Names{});
  EXPECT_EQ(changes_, 5);
  readers_.gone(reader(9, 1));
  EXPECT_EQ(changes_, 5);
}

TEST_F(RobotReadersTest, MayChangeTheirPartitions) {
  readers_.found(reader(1, 1), {"default/robot/a"});
  readers_.found(reader(1, 1), {"default/robot/b"});
  EXPECT_EQ(readers_.robots(), Names{"b"});
  readers_.found(reader(1, 1), {"default"});
  EXPECT_EQ(readers_.robots(), Names{});
}

}  // namespace
}  // namespace accord::dds
