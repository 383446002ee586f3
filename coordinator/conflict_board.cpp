#include "coordinator/conflict_board.h"

#include <algorithm>
#include <limits>

namespace accord {
namespace {

// Slabs in which a robot of usual speed moves about as far as it is long: shorter ones cost memory,
// longer ones let boxes of robots meet that never do.
constexpr double kSlabsPerRun = 64;

double slab_length(const Scene& scene, const Schedule& schedule) {
  double end = 0;
  for (std::uint32_t r = 0; r < schedule.size(); ++r) {
    end = std::max(end, schedule.path({r}).end_time());
  }
  return std::max(end / kSlabsPerRun, scene.timestep);
}

// Twice the mean extent of what a robot sweeps in a slab.
double cell_size(const CollisionWorld& world, const Schedule& schedule, double slab) {
  double sum = 0;
  for (std::uint32_t r = 0; r < schedule.size(); ++r) {
    const Trajectory& path = schedule.path({r});
    const Aabb box = world.swept_bounds({r}, path.configuration(0), path.at(slab));
    sum += (box.max - box.min).head<2>().maxCoeff();
  }
  const double mean = sum / static_cast<double>(std::max<std::size_t>(schedule.size(), 1));
  return std::max(2 * mean, 1e-3);
}

}  // namespace

ConflictBoard::ConflictBoard(const CollisionWorld& world, const Schedule& schedule)
    : world_(world),
      schedule_(schedule),
      grid_(world, slab_length(world.scene(), schedule),
            cell_size(world, schedule, slab_length(world.scene(), schedule))) {
  std::vector<RobotId> all;
  for (std::uint32_t r = 0; r < schedule.size(); ++r) all.push_back({r});
  update(all, 0);
}

void ConflictBoard::update(const std::vector<RobotId>& changed, double from) {
  forget(changed, from);
  for (const RobotId robot : changed) grid_.place(robot, schedule_.path(robot), from);
  flags_.assign(schedule_.size(), 0);
  for (const RobotId robot : changed) {
    scan(robot, from);
    flags_[robot.index()] = 1;
  }
}

void ConflictBoard::forget(const std::vector<RobotId>& changed, double from) {
  flags_.assign(schedule_.size(), 0);
  for (const RobotId robot : changed) flags_[robot.index()] = 1;
  for (auto i = by_time_.lower_bound({{0}, {0}, from}); i != by_time_.end();) {
    if (flags_[i->first.index()] || flags_[i->second.index()]) {
      times_.erase({i->first, i->second});
      i = by_time_.erase(i);
    } else {
      ++i;
    }
  }
}

void ConflictBoard::scan(RobotId robot, double from) {
  std::vector<RobotId> neighbours;
  const std::size_t first = grid_.slab_of(from);
  for (std::size_t slab = first; slab < grid_.slabs(); ++slab) {
    grid_.neighbours(robot, slab, neighbours);
    const double begin = std::max(from, grid_.slab_start(slab));
    const bool last = slab + 1 == grid_.slabs();
    const double end = last ? std::numeric_limits<double>::infinity() : grid_.slab_start(slab + 1);
    for (const RobotId other : neighbours) {
      if (flags_[other.index()]) continue;  // this pair was scanned from the other side
      const Pair pair{std::min(robot, other), std::max(robot, other)};
      if (times_.contains(pair)) continue;  // an earlier one stands
      ++pair_checks_;
      const auto time = earliest_contact(world_, pair.first, schedule_.path(pair.first),
                                         pair.second, schedule_.path(pair.second), begin, end);
      if (!time) continue;
      times_.emplace(pair, *time);
      by_time_.insert({pair.first, pair.second, *time});
    }
  }
}

}  // namespace accord
