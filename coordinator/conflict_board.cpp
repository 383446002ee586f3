#include "coordinator/conflict_board.h"

#include <algorithm>
#include <cmath>
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

// Where the robots start and end; they hardly ever go far beyond.
Aabb area_of(const CollisionWorld& world, const Schedule& schedule) {
  Aabb area{Vec3::Zero(), Vec3::Zero()};
  for (std::uint32_t r = 0; r < schedule.size(); ++r) {
    const Trajectory& path = schedule.path({r});
    const Aabb box =
        world.swept_bounds({r}, path.configuration(0), path.configuration(path.size() - 1));
    if (r == 0) area = box;
    area.merge(box);
  }
  return area;
}

// Twice the mean extent of what a robot sweeps in a slab, but no more cells than robots.
double cell_size(const CollisionWorld& world, const Schedule& schedule, double slab,
                 const Aabb& area) {
  double sum = 0;
  for (std::uint32_t r = 0; r < schedule.size(); ++r) {
    const Trajectory& path = schedule.path({r});
    const Aabb box = world.swept_bounds({r}, path.configuration(0), path.at(slab));
    sum += (box.max - box.min).head<2>().maxCoeff();
  }
  const auto robots = static_cast<double>(std::max<std::size_t>(schedule.size(), 1));
  const double share = std::sqrt((area.max - area.min).head<2>().prod() / robots);
  return std::max({2 * sum / robots, share, 1e-3});
}

SpaceTimeGrid empty_grid(const CollisionWorld& world, const Schedule& schedule) {
  const double slab = slab_length(world.scene(), schedule);
  const Aabb area = area_of(world, schedule);
  return {world, slab, area, cell_size(world, schedule, slab, area)};
}

}  // namespace

ConflictBoard::ConflictBoard(const CollisionWorld& world, const Schedule& schedule)
    : world_(world),
      schedule_(schedule),
      grid_(empty_grid(world, schedule)),
      by_robot_(schedule.size()),
      is_done_(schedule.size(), 0) {
  for (std::uint32_t r = 0; r < schedule.size(); ++r) grid_.place({r}, schedule.path({r}), 0);
}

ConflictBoard::ConflictBoard(const ConflictBoard& other, const Schedule& schedule)
    : world_(other.world_),
      schedule_(schedule),
      grid_(other.grid_),
      by_time_(other.by_time_),
      by_robot_(other.by_robot_),
      is_done_(other.is_done_),
      looked_(other.looked_),
      found_(other.found_),
      pair_checks_(other.pair_checks_) {}

bool ConflictBoard::look_ahead(std::size_t enough, double reach) {
  std::vector<RobotId> all;
  while (looked_ < grid_.slabs()) {
    if (!by_time_.empty() && by_time_.size() >= enough &&
        grid_.slab_start(looked_) >= by_time_.begin()->time + reach) {
      break;
    }
    if (all.empty()) {
      for (std::uint32_t r = 0; r < schedule_.size(); ++r) all.push_back({r});
    }
    const std::size_t before = by_time_.size();
    scan(all, grid_.slab_start(looked_), looked_, looked_ + 1);
    found_ += by_time_.size() - before;
    ++looked_;
  }
  return !by_time_.empty();
}

bool ConflictBoard::look_at_all() {
  return look_ahead(std::numeric_limits<std::size_t>::max(), 0);
}

double ConflictBoard::seen_until() const {
  return looked_ < grid_.slabs() ? grid_.slab_start(looked_)
                                 : std::numeric_limits<double>::infinity();
}

void ConflictBoard::update(const std::vector<RobotId>& changed, double from) {
  const bool has_looked_at_all = looked_ == grid_.slabs();
  const std::size_t before = by_time_.size();
  for (const RobotId robot : changed) {
    forget(robot, from);
    grid_.place(robot, schedule_.path(robot), from);
  }
  // Those who have not changed are parked where the grid has become longer.
  if (has_looked_at_all) looked_ = grid_.slabs();
  scan(changed, from, grid_.slab_of(from), looked_);
  if (by_time_.size() > before) found_ += by_time_.size() - before;
}

void ConflictBoard::scan(const std::vector<RobotId>& robots, double from, std::size_t first_slab,
                         std::size_t last_slab) {
  for (const RobotId robot : robots) {
    scan(robot, from, first_slab, last_slab);
    is_done_[robot.index()] = 1;  // pairs with it are scanned from its side
  }
  for (const RobotId robot : robots) is_done_[robot.index()] = 0;
}

void ConflictBoard::forget(RobotId robot, double from) {
  std::erase_if(by_robot_[robot.index()], [&](const WithOther& own) {
    if (own.time < from) return false;
    by_time_.erase({std::min(robot, own.other), std::max(robot, own.other), own.time});
    std::erase_if(by_robot_[own.other.index()],
                  [&](const WithOther& back) { return back.other == robot; });
    return true;
  });
}

void ConflictBoard::scan(RobotId robot, double from, std::size_t first_slab,
                         std::size_t last_slab) {
  // Of a pair the earliest conflict counts: those that have one are done.
  std::vector<RobotId> done;
  const auto set_done = [&](RobotId other) {
    if (is_done_[other.index()]) return;
    is_done_[other.index()] = 1;
    done.push_back(other);
  };
  for (const WithOther& own : by_robot_[robot.index()]) set_done(own.other);
  std::vector<RobotId> neighbours;
  for (std::size_t slab = first_slab; slab < last_slab; ++slab) {
    grid_.neighbours(robot, slab, neighbours);
    const double begin = std::max(from, grid_.slab_start(slab));
    const bool last = slab + 1 == grid_.slabs();
    const double end = last ? std::numeric_limits<double>::infinity() : grid_.slab_start(slab + 1);
    for (const RobotId other : neighbours) {
      if (is_done_[other.index()]) continue;
      ++pair_checks_;
      const RobotId first = std::min(robot, other), second = std::max(robot, other);
      const auto time = earliest_contact(world_, first, schedule_.path(first), second,
                                         schedule_.path(second), begin, end);
      if (!time) continue;
      add({first, second, *time});
      set_done(other);
    }
  }
  for (const RobotId other : done) is_done_[other.index()] = 0;
}

void ConflictBoard::add(const Conflict& conflict) {
  by_time_.insert(conflict);
  by_robot_[conflict.first.index()].push_back({conflict.second, conflict.time});
  by_robot_[conflict.second.index()].push_back({conflict.first, conflict.time});
}

}  // namespace accord
