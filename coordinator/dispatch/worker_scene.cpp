#include "coordinator/dispatch/worker_scene.h"

#include <algorithm>

namespace accord {
namespace {

// The zero of every joint, or the limit that is nearest to it.
Configuration place_of(const RobotModel& arm) {
  Configuration q;
  for (const DegreeOfFreedom& dof : arm.dofs) q.push_back(std::clamp(0.0, dof.lower, dof.upper));
  return q;
}

}  // namespace

Scene scene_for_workers(const Scene& scene) {
  Scene out = scene;
  for (Robot& robot : out.robots) {
    if (robot.model->kind == RobotKind::kArm) robot.start = robot.goal = place_of(*robot.model);
  }
  return out;
}

}  // namespace accord
