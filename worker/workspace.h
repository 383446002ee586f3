// What solvers work with: the scene's geometry, and the robots' roadmaps, which robots of the same
// model in the same place share.
// Thread safe.
#pragma once

#include <memory>
#include <vector>

#include "common/geometry/collision_world.h"
#include "worker/robot_roadmap.h"

namespace accord {

class Workspace {
 public:
  // The world must outlive this. Cheap: roadmaps are built when first asked.
  explicit Workspace(const CollisionWorld& world);

  const CollisionWorld& world() const { return world_; }
  const RobotRoadmap& roadmap(RobotId robot) const { return *roadmaps_[robot.index()]; }

 private:
  const CollisionWorld& world_;
  std::vector<std::shared_ptr<RobotRoadmap>> roadmaps_;  // by robot; shared
};

}  // namespace accord
