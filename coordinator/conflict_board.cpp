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
  const auto is_changed = [&](RobotId robot) { return std::ranges::count(changed, robot) > 0; };
  std::erase_if(conflicts_, [&](const auto& entry) {
    const auto& [pair, time] = entry;
    return time >= from && (is_changed(pair.first) || is_changed(pair.second));
  });
  for (const RobotId robot : changed) grid_.place(robot, schedule_.path(robot), from);
  scanned_.assign(schedule_.size(), 0);
  for (const RobotId robot : changed) {
    scan(robot, from);
    scanned_[robot.index()] = 1;
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
      if (scanned_[other.index()]) continue;  // this pair was scanned from the other side
      const Pair pair{std::min(robot, other), std::max(robot, other)};
      if (conflicts_.contains(pair)) continue;  // an earlier one stands
      ++pair_checks_;
      const auto time = earliest_contact(world_, pair.first, schedule_.path(pair.first),
                                         pair.second, schedule_.path(pair.second), begin, end);
      if (time) conflicts_.emplace(pair, *time);
    }
  }
}

std::vector<Conflict> ConflictBoard::conflicts() const {
  std::vector<Conflict> all;
  all.reserve(conflicts_.size());
  for (const auto& [pair, time] : conflicts_) all.push_back({pair.first, pair.second, time});
  std::ranges::stable_sort(all, {}, &Conflict::time);
  return all;
}

}  // namespace accord
