// What planar scenes ask of arms: that they stay in the plane z = 0.
#pragma once

#include "common/io/urdf.h"
#include "common/model/robot.h"

namespace accord {

// Joints turn about axes parallel to z, of either sign; others are reported in the URDF's lines.
void check_planar_joints(const UrdfModel& arm, Faults& faults);

// Bodies meet the plane where the arm stands; the robot is to blame. Requires: joints passed
// check_planar_joints(), so that heights do not depend on the configuration.
void check_planar_bodies(const Robot& robot, const Blame& blame);

}  // namespace accord
