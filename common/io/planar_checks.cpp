#include "common/io/planar_checks.h"

#include <algorithm>
#include <vector>

#include "common/geometry/planar_cut.h"
#include "common/io/words.h"

namespace accord {
namespace {

// Each link's frame in the arm's base frame, with all joints at 0.
std::vector<Pose> link_poses(const RobotModel& model) {
  std::vector<Pose> poses(model.links.size(), Pose::Identity());
  for (const Joint& joint : model.joints) {
    poses[static_cast<std::size_t>(joint.child)] =
        poses[static_cast<std::size_t>(joint.parent)] * joint.origin;
  }
  return poses;
}

}  // namespace

void check_planar_joints(const UrdfModel& arm, Faults& faults) {
  const std::vector<Pose> poses = link_poses(arm.model);
  for (std::size_t i = 0; i < arm.model.joints.size(); ++i) {
    const Joint& joint = arm.model.joints[i];
    if (joint.type == JointType::kFixed) continue;
    const Vec3 axis = poses[static_cast<std::size_t>(joint.child)].linear() * joint.axis;
    if (joint.type == JointType::kPrismatic) {
      faults.add(arm.joint_places[i],
                 "prismatic joints are for spatial scenes; in a planar one joints turn about z");
    } else if (axis.head<2>().norm() > kPlanarTilt) {
      faults.add(arm.joint_places[i], "its axis must be parallel to z in a planar scene, but is (" +
                                          in_words(axis.x()) + ", " + in_words(axis.y()) + ", " +
                                          in_words(axis.z()) + ")");
    }
  }
}

void check_planar_bodies(const Robot& robot, const Blame& blame) {
  const std::vector<Pose> poses = link_poses(*robot.model);
  for (const Body& body : robot.model->bodies) {
    const Pose pose = robot.base * poses[static_cast<std::size_t>(body.link)] * body.pose;
    if (const auto cut = planar_cut(body.shape, pose); !cut) {
      blame("the body of link " + in_quotes(body.name) + " " + cut.error());
    }
  }
}

}  // namespace accord
