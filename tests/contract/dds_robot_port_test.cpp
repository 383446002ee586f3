// A robot that reads in its own partition gets its own path, all of it, and nothing else.
#include <gtest/gtest.h>

#include <chrono>

#include "common/transport/dds/fleet/participant.h"
#include "common/transport/fleet/dds_fleet.h"
#include "common/transport/fleet/robot_partition.h"
#include "common/transport/fleet/robot_port.h"
#include "tests/contract/dds_world.h"
#include "tests/contract/fleet_samples.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using fleet_samples::plan_of;
using Clock = std::chrono::steady_clock;
using Transport = DdsOptions::Transport;

class DdsRobotPort : public ::testing::TestWithParam<Transport> {
 protected:
  std::unique_ptr<RobotPort> port_of(const std::string& robot) {
    auto port = make_dds_robot_port(options_, robot);
    if (!port) throw std::runtime_error(port.error());
    return std::move(*port);
  }
  static std::optional<RobotPath> next(RobotPort& port, std::chrono::milliseconds timeout = 10s) {
    const auto end = Clock::now() + timeout;
    while (true) {
      if (auto path = port.take()) return path;
      if (Clock::now() > end) return std::nullopt;
      port.wait(20ms);
    }
  }

  DdsOptions options_ = local_dds(GetParam());
  std::unique_ptr<FleetServicePort> service_ = *make_dds_fleet_service(options_, [] {});
};

TEST_P(DdsRobotPort, GetsTheRobotsLatestPathHoweverLate) {
  const FinishedPlan first = plan_of("first", 3, 10), second = plan_of("second", 3, 9'000);
  const RobotPlan& robot = second.plan.robots[1];
  service_->publish(first);
  service_->publish(second);
  for (int times = 0; times < 3; ++times) {
    const auto port = port_of(robot.name);
    const auto path = next(*port);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->id, "second");
    EXPECT_EQ(path->trajectory, robot.trajectory);
    EXPECT_FALSE(next(*port, 100ms)) << "nothing else";
  }
}

TEST_P(DdsRobotPort, GetsEveryPathThatIsPlannedWhileItIsThere) {
  const std::string robot = plan_of("0", 3, 10).plan.robots[2].name;
  service_->publish(plan_of("0", 3, 10));
  const auto port = port_of(robot);
  ASSERT_TRUE(next(*port));
  for (int i = 1; i <= 20; ++i) {
    const std::string id = std::to_string(i);
    service_->publish(plan_of(id, 3, 10));
    const auto path = next(*port);
    ASSERT_TRUE(path) << id;
    EXPECT_EQ(path->id, id);
    EXPECT_EQ(path->robot, robot);
  }
}

// Whoever else speaks DDS reads in a partition just so. A filter in our own reader would be none.
TEST_P(DdsRobotPort, IsSentNoOtherRobotsPath) {
  const FinishedPlan plan = plan_of("1", 50, 10);
  const std::string robot = plan.plan.robots[7].name;
  auto participant = dds::FleetParticipant::create(
      options_, robot_partition(options_.cluster, robot), dds::kClientRole, nullptr, nullptr);
  ASSERT_TRUE(participant);
  auto* reader = (*participant)->add_robot_path_reader(nullptr);
  ASSERT_NE(reader, nullptr);
  service_->publish(plan);
  std::vector<std::string> robots;
  const auto end = Clock::now() + 10s;
  for (auto quiet = end; Clock::now() < std::min(quiet, end);) {
    if (const auto piece = dds::read<PathPiece>(*reader)) {
      robots.push_back(piece->robot);
      quiet = Clock::now() + 200ms;
    } else {
      reader->wait_for_unread_message({0, 20'000'000});
    }
  }
  EXPECT_EQ(robots, std::vector<std::string>{robot});
}

TEST_P(DdsRobotPort, IsServedAsOthersComeAndGo) {
  const FinishedPlan plan = plan_of("1", 20, 10);
  service_->publish(plan);
  for (const RobotPlan& robot : plan.plan.robots) {
    const auto path = next(*port_of(robot.name));
    ASSERT_TRUE(path) << robot.name;
    EXPECT_EQ(path->trajectory, robot.trajectory);
  }
}

TEST(DdsRobotPortOfANameWithWildcards, IsNone) {
  const auto port = make_dds_robot_port(local_dds(Transport::kUdp), "agv*");
  ASSERT_FALSE(port);
  EXPECT_EQ(port.error(),
            "robot: expected a name of at most 200 bytes without '*', '?', '[' and ']'");
}

INSTANTIATE_TEST_SUITE_P(Transports, DdsRobotPort,
                         ::testing::Values(Transport::kSharedMemory, Transport::kUdp),
                         [](const auto& param_info) {
                           return param_info.param == Transport::kUdp ? "Udp" : "SharedMemory";
                         });

}  // namespace
}  // namespace accord
