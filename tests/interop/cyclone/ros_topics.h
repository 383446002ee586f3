// What a node of ROS 2 hears of a robot's path.
#pragma once

#include <dds/dds.h>
#include <stdbool.h>
#include <stdint.h>

// Waits for the latest message on rt/NAME/ROBOT/KIND until `end`, and prints it (JSON; times as
// seconds and nanoseconds). `kind` is "path" or "joint_trajectory", `robot` the robot as in the
// topic. False, with a line on stderr: none has come.
bool print_ros(uint32_t domain, const char* name, const char* robot, const char* kind,
               dds_time_t end);
