// A roadmap of one robot's whole configuration space (PRM; Kavraki et al. 1996), shared by all
// robots of the same model in the same place. Grows by levels; a level's nodes and edges depend on
// the scene alone, so that every process that builds it has the same one. Edges are proved when
// first needed, and remembered.
// Thread safe.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/local_roadmap.h"

namespace accord {

class RobotRoadmap {
 public:
  static constexpr std::size_t kLevels = 4;

  // `robot` stands for all that share the roadmap. Cheap: levels are built when asked for.
  RobotRoadmap(const CollisionWorld& world, RobotId robot);
  ~RobotRoadmap();

  // The first level whose nodes lie no further apart than a mobile robot is large, so that there
  // are places to make way to wherever it is; the last level where none does, the first for arms.
  std::size_t dense_level() const { return dense_level_; }

  // The shortest path (in time) from start to goal on the roadmap of `level` (from 0), as
  // configurations from start to goal, numbers running on over whole turns; nullopt: none.
  // Requires: start and goal are free, level < kLevels.
  std::optional<std::vector<Configuration>> query(std::size_t level, ConfigurationView start,
                                                  ConfigurationView goal, Effort& effort) const;

  // Adds a level's nodes that lie in the region, and the edges between them, to a local roadmap of
  // a team of this robot alone. Requires: level < kLevels.
  void copy_into(std::size_t level, const Region& region, const Team& team,
                 LocalRoadmap& out) const;

 private:
  struct Level;
  const Level& level(std::size_t index) const;

  const CollisionWorld& world_;
  RobotId robot_;
  std::size_t dense_level_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Level>> levels_;
};

}  // namespace accord
