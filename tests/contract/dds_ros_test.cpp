// Paths on topics of ROS 2, read as ROS's own nodes read them: by their topics' and types' names,
// in no partition.
#include <gtest/gtest.h>

#include <chrono>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "common/transport/dds/domain.h"
#include "common/transport/dds/qos.h"
#include "common/transport/fleet/dds_fleet.h"
#include "rosPubSubTypes.h"
#include "tests/contract/dds_world.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using eprosima::fastdds::dds::DataReader;
using eprosima::fastdds::dds::TypeSupport;
using JointTrajectory = trajectory_msgs::msg::dds_::JointTrajectory_;
using Path = nav_msgs::msg::dds_::Path_;

// A node of ROS, as far as DDS is concerned.
class Node {
 public:
  explicit Node(const DdsOptions& options) : participant_(*dds::join_domain(options, "", nullptr)) {
    subscriber_ = participant_->create_subscriber(eprosima::fastdds::dds::SUBSCRIBER_QOS_DEFAULT);
  }
  ~Node() { dds::leave_domain(*participant_); }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  // The first message on a topic; nullopt: none in time.
  template <typename Message, typename Support>
  std::optional<Message> read(const std::string& topic, std::chrono::milliseconds timeout = 10s) {
    DataReader* reader = subscriber_->create_datareader(
        dds::add_topic(*participant_, topic, TypeSupport(new Support())),
        dds::latest_reader_qos(1, true));
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (std::chrono::steady_clock::now() < end) {
      Message message;
      eprosima::fastdds::dds::SampleInfo info;
      if (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) return message;
      reader->wait_for_unread_message({0, 20'000'000});
    }
    return std::nullopt;
  }

 private:
  eprosima::fastdds::dds::DomainParticipant* participant_;
  eprosima::fastdds::dds::Subscriber* subscriber_;
};

class DdsRos : public ::testing::Test {
 protected:
  std::unique_ptr<FleetServicePort> service(const RosOptions& ros) {
    return *make_dds_fleet_service(
        options_, [] {}, ros);
  }
  FinishedPlan plan() const {
    FinishedPlan out{"1", {}, scene_};
    out.plan.status = PlanStatus::kSolved;
    out.plan.scene = scene_->name;
    for (const Robot& robot : scene_->robots) {
      out.plan.robots.push_back(
          {robot.name, testing::path({{0, robot.start}, {4, robot.goal}}), {}});
    }
    return out;
  }
  std::optional<Path> path_on(const std::string& topic, std::chrono::milliseconds timeout = 10s) {
    return Node(options_).read<Path, nav_msgs::msg::dds_::Path_PubSubType>(topic, timeout);
  }

  DdsOptions options_ = local_dds(DdsOptions::Transport::kUdp);
  std::shared_ptr<const Scene> scene_ =
      testing::SceneBuilder(-9, -9, 9, 9)
          .disk(0.5, {-5, 0}, {5, 1})
          .robot(testing::planar_arm_model({1, 0.8}), {0.8, 0}, {-0.8, 0.5})
          .disk(0.5, {-5, 3}, {5, 4})
          .build();
};

TEST_F(DdsRos, HasThePathsOfMobileRobotsAndTheTrajectoriesOfArms) {
  const auto port = service({"accord/hall", "map"});
  port->publish(plan());
  const auto path = path_on("rt/accord/hall/r0/path");
  ASSERT_TRUE(path);
  EXPECT_EQ(path->header().frame_id(), "map");
  ASSERT_EQ(path->poses().size(), 2U);
  EXPECT_EQ(path->poses()[1].pose().position().x(), 5);
  EXPECT_EQ(path->poses()[1].header().stamp().sec(), 4);
  const auto trajectory =
      Node(options_).read<JointTrajectory, trajectory_msgs::msg::dds_::JointTrajectory_PubSubType>(
          "rt/accord/hall/r1/joint_trajectory");
  ASSERT_TRUE(trajectory);
  ASSERT_EQ(trajectory->points().size(), 2U);
  EXPECT_EQ(trajectory->points()[1].positions(), (std::vector<double>{-0.8, 0.5}));
  EXPECT_EQ(trajectory->points()[1].time_from_start().sec(), 4);
}

TEST_F(DdsRos, HasATopicForEachRobot) {
  const auto port = service({"accord", "map"});
  port->publish(plan());
  for (const auto& [robot, y] : {std::pair{"r0", 1.0}, std::pair{"r2", 4.0}}) {
    const auto path = path_on("rt/accord/" + std::string(robot) + "/path");
    ASSERT_TRUE(path) << robot;
    EXPECT_EQ(path->poses()[1].pose().position().y(), y);
  }
}

TEST_F(DdsRos, HasTheLatestPathForWhoComesLater) {
  const auto port = service({"accord", "map"});
  FinishedPlan second = plan();
  second.id = "2";
  second.plan.robots[0].trajectory = testing::path({{0, {-5, 0}}, {9, {5, 1}}});
  port->publish(plan());
  port->publish(second);
  for (int i = 0; i < 2; ++i) {
    const auto path = path_on("rt/accord/r0/path");
    ASSERT_TRUE(path);
    EXPECT_EQ(path->poses()[1].header().stamp().sec(), 9);
  }
}

TEST_F(DdsRos, HasNothingUnlessSwitchedOn) {
  const auto port = service({});
  port->publish(plan());
  EXPECT_FALSE(path_on("rt/accord/r0/path", 300ms));
  EXPECT_FALSE(path_on("rt//r0/path", 300ms));
}

}  // namespace
}  // namespace accord
