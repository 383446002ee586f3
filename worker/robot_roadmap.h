// The roadmaps of one robot's whole configuration space (PRM; Kavraki et al. 1996), shared by all
// robots of the same model in the same place. They come in levels of more and more nodes; a level's
// nodes and edges depend on the scene alone, so that every process that builds it has the same one.
// Thread safe.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/shared_roadmap.h"

namespace accord {

class RobotRoadmap {
 public:
  static constexpr std::size_t kLevels = kRoadmapLevels;

  // `robot` stands for all that share the roadmap. Cheap: levels are built when asked for.
  RobotRoadmap(const CollisionWorld& world, RobotId robot);

  // Requires: index < kLevels.
  const SharedRoadmap& level(std::size_t index) const;

  // For traffic: nodes lie no further apart than a mobile robot is large, so that there are places
  // to make way to wherever it is, and around each start and goal of others, so that it can pass
  // who stands there. Of arms the first level.
  const SharedRoadmap& dense() const;

 private:
  const CollisionWorld& world_;
  RobotId robot_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<SharedRoadmap>> levels_;
  mutable std::unique_ptr<SharedRoadmap> dense_;
};

}  // namespace accord
