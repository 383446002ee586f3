#include "common/transport/dds/ros/ros_writers.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "common/transport/dds/domain.h"
#include "common/transport/dds/qos.h"
#include "common/transport/dds/ros/ros_conversions.h"
#include "common/transport/ros/ros_names.h"
#include "rosPubSubTypes.h"

namespace accord::dds {

using eprosima::fastdds::dds::DataWriter;
using eprosima::fastdds::dds::Topic;
using eprosima::fastdds::dds::TypeSupport;

RosWriters::RosWriters(eprosima::fastdds::dds::DomainParticipant& participant, RosOptions options)
    : participant_(participant), options_(std::move(options)) {}

RosWriters::~RosWriters() {
  for (const auto& [topic, writer] : writers_) {
    if (writer == nullptr) continue;
    Topic* its = writer->get_topic();
    publisher_->delete_datawriter(writer);
    participant_.delete_topic(its);
  }
  if (publisher_ != nullptr) participant_.delete_publisher(publisher_);
}

template <typename Support>
DataWriter* RosWriters::writer_of(const std::string& topic) {
  if (const auto known = writers_.find(topic); known != writers_.end()) return known->second;
  if (writers_.size() >= kMost) return nullptr;
  DataWriter* writer = nullptr;
  if (publisher_ == nullptr) {
    // In no partition, where ROS is.
    publisher_ = participant_.create_publisher(eprosima::fastdds::dds::PUBLISHER_QOS_DEFAULT);
  }
  Topic* made = add_topic(participant_, topic, TypeSupport(new Support()));
  if (made != nullptr && publisher_ != nullptr) {
    writer = publisher_->create_datawriter(made, latest_writer_qos(1));
  }
  if (writer == nullptr) spdlog::warn("topics: DDS refused a writer for {}", topic);
  writers_.emplace(topic, writer);
  return writer;
}

void RosWriters::publish(const Plan& plan, const Scene& scene) {
  if (options_.name.empty()) return;
  const auto& robots = plan.robots;
  std::vector<std::string> names;
  for (const RobotPlan& robot : robots) names.push_back(robot.name);
  const std::vector<std::string> tokens = ros_tokens(names);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Robot& robot = scene.robots[i];
    const std::string topic = "rt/" + options_.name + "/" + tokens[i];
    if (robot.model->kind == RobotKind::kArm) {
      DataWriter* writer = writer_of<trajectory_msgs::msg::dds_::JointTrajectory_PubSubType>(
          topic + "/joint_trajectory");
      if (writer == nullptr) continue;
      auto message = to_joint_trajectory(robots[i].trajectory, robot, options_.frame);
      writer->write(&message);
    } else {
      DataWriter* writer = writer_of<nav_msgs::msg::dds_::Path_PubSubType>(topic + "/path");
      if (writer == nullptr) continue;
      auto message = to_path(robots[i].trajectory, robot, options_.frame);
      writer->write(&message);
    }
  }
}

}  // namespace accord::dds
