// Broad phase in space and time: which robots could meet, and when. Time is cut into slabs; in each
// slab a robot is the box that holds all it sweeps, filed under the cells that the box covers. What
// a robot's change costs grows with its own path, not with the number of robots.
// Not thread safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/model/trajectory.h"

namespace accord {

class SpaceTimeGrid {
 public:
  // slab (s), the area (m) that is cut into cells, and cell (m) are tuning: answers do not depend
  // on them. What lies beyond the area is filed under its outermost cells.
  SpaceTimeGrid(const CollisionWorld& world, double slab, const Aabb& area, double cell);

  // Files a robot's path anew from time `from` (s) on; before, it must be as filed. Robots park at
  // their ends. Paths that reach past the last slab lengthen the grid for all.
  void place(RobotId robot, const Trajectory& path, double from);

  std::size_t slabs() const { return slabs_; }
  double slab_start(std::size_t slab) const { return static_cast<double>(slab) * slab_; }
  std::size_t slab_of(double t) const;

  // The other robots whose boxes come within the required separation of this robot's in a slab, in
  // no particular order.
  void neighbours(RobotId robot, std::size_t slab, std::vector<RobotId>& out) const;

  // The robots whose boxes meet `box` in any slab of [from, until] (s), ascending.
  void within(const Aabb& box, double from, double until, std::vector<RobotId>& out) const;

 private:
  // A robot's box in a slab, next to its name, so that a look into a cell stays there.
  struct Filed {
    RobotId robot;
    Aabb box;  // inflated by half the required separation
  };

  void extend_to(std::size_t slabs);
  void file(RobotId robot, std::size_t slab, const Aabb& box);
  void remove(RobotId robot, std::size_t slab);
  // Adds the robots filed under the box's cells of a slab whose boxes meet it and that have not
  // been added since out was cleared by begin().
  void begin(std::vector<RobotId>& out) const;
  void collect(const Aabb& box, std::size_t slab, std::vector<RobotId>& out) const;
  // Calls visit with the index into cells_ of each cell that the box covers.
  template <class Visit>
  void for_each_cell(const Aabb& box, std::size_t slab, const Visit& visit) const;

  // Cells along one axis of the area.
  struct Axis {
    Axis(double low, double high, double cell);
    std::size_t index(double x) const;

    double low;        // m
    double per_metre;  // cells
    std::size_t cells;
  };

  const CollisionWorld& world_;
  double slab_;
  Axis columns_;
  Axis rows_;
  std::size_t slabs_ = 0;
  std::vector<std::vector<Aabb>> boxes_;         // by robot, then slab
  std::vector<std::vector<Filed>> cells_;        // by slab, then row, then column
  mutable std::vector<std::uint64_t> added_in_;  // by robot: the last question that it answered
  mutable std::uint64_t question_ = 0;
};

}  // namespace accord
