#include "common/transport/dds/ros/ros_conversions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace accord::dds {
namespace {

// t >= 0, s. Beyond what ROS can say (68 years) it is the longest that it can.
template <typename Time>
Time to_time(double t) {
  constexpr double kNano = 1e9;
  double whole = std::floor(t);
  auto nano = static_cast<std::uint32_t>(std::lround((t - whole) * kNano));
  if (nano >= static_cast<std::uint32_t>(kNano)) {
    whole += 1;
    nano = 0;
  }
  constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
  Time out;
  out.sec(whole >= kMost ? kMost : static_cast<std::int32_t>(whole));
  out.nanosec(nano);
  return out;
}

Pose pose_of(const Robot& robot, ConfigurationView q) {
  Pose pose = Pose::Identity();
  const std::size_t translations = robot.model->translations();
  for (std::size_t k = 0; k < translations; ++k) {
    pose.translation()[static_cast<Eigen::Index>(k)] = q[k];
  }
  if (robot.model->kind == RobotKind::kFootprint) {
    pose.linear() = Eigen::AngleAxisd(q[2], Vec3::UnitZ()).toRotationMatrix();
  }
  return robot.base * pose;
}

geometry_msgs::msg::dds_::Pose_ to_pose(const Pose& pose) {
  geometry_msgs::msg::dds_::Pose_ out;
  out.position().x(pose.translation().x());
  out.position().y(pose.translation().y());
  out.position().z(pose.translation().z());
  const Eigen::Quaterniond turn(pose.linear());
  out.orientation().x(turn.x());
  out.orientation().y(turn.y());
  out.orientation().z(turn.z());
  out.orientation().w(turn.w());
  return out;
}

}  // namespace

trajectory_msgs::msg::dds_::JointTrajectory_ to_joint_trajectory(const Trajectory& path,
                                                                 const Robot& robot,
                                                                 const std::string& frame) {
  trajectory_msgs::msg::dds_::JointTrajectory_ out;
  out.header().frame_id(frame);
  for (const DegreeOfFreedom& dof : robot.model->dofs) out.joint_names().push_back(dof.name);
  out.points().reserve(path.size());
  for (std::size_t k = 0; k < path.size(); ++k) {
    trajectory_msgs::msg::dds_::JointTrajectoryPoint_& point = out.points().emplace_back();
    const ConfigurationView q = path.configuration(k);
    point.positions().assign(q.begin(), q.end());
    point.time_from_start(to_time<builtin_interfaces::msg::dds_::Duration_>(path.time(k)));
  }
  return out;
}

nav_msgs::msg::dds_::Path_ to_path(const Trajectory& path, const Robot& robot,
                                   const std::string& frame) {
  nav_msgs::msg::dds_::Path_ out;
  out.header().frame_id(frame);
  out.poses().reserve(path.size());
  for (std::size_t k = 0; k < path.size(); ++k) {
    geometry_msgs::msg::dds_::PoseStamped_& stamped = out.poses().emplace_back();
    stamped.header().frame_id(frame);
    stamped.header().stamp(to_time<builtin_interfaces::msg::dds_::Time_>(path.time(k)));
    stamped.pose(to_pose(pose_of(robot, path.configuration(k))));
  }
  return out;
}

}  // namespace accord::dds
