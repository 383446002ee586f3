// A robot's path in the messages of ROS 2. Pure functions; thread safe.
#pragma once

#include <string>

#include "common/model/plan.h"
#include "common/model/scene.h"
#include "ros.h"

namespace accord::dds {

// Of an arm: points at the waypoints, times from the plan's start. Requires: robot.model is an arm.
trajectory_msgs::msg::dds_::JointTrajectory_ to_joint_trajectory(const Trajectory& path,
                                                                 const Robot& robot,
                                                                 const std::string& frame);

// Of any other robot: poses at the waypoints, stamped with the times from the plan's start. A
// robot's place is that of its origin; discs and balls have no heading, and get the base's.
nav_msgs::msg::dds_::Path_ to_path(const Trajectory& path, const Robot& robot,
                                   const std::string& frame);

}  // namespace accord::dds
