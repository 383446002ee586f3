#include "coordinator/space_time_grid.h"

#include <algorithm>
#include <cmath>

#include "common/planning/random.h"

namespace accord {
namespace {

std::int64_t cell_index(double x, double cell) {
  return static_cast<std::int64_t>(std::floor(x / cell));
}

// The box of everything that a path sweeps in [from, until].
Aabb swept(const CollisionWorld& world, RobotId robot, const Trajectory& path, double from,
           double until) {
  Configuration a = path.at(from), b(path.dof());
  std::size_t i = path.segment_at(from);
  Aabb box = world.swept_bounds(robot, a, a);
  for (double t = from; t < until;) {
    const double next = i + 1 < path.size() ? std::min(path.time(i + 1), until) : until;
    path.at(next, b);
    if (i + 1 < path.size() && next > path.time(i)) box.merge(world.swept_bounds(robot, a, b));
    a.swap(b);
    t = next;
    if (++i >= path.size()) break;
  }
  return box;
}

}  // namespace

SpaceTimeGrid::SpaceTimeGrid(const CollisionWorld& world, double slab, double cell)
    : world_(world),
      slab_(slab),
      cell_(cell),
      boxes_(world.scene().robots.size()),
      added_in_(world.scene().robots.size(), 0) {}

std::size_t SpaceTimeGrid::slab_of(double t) const {
  return static_cast<std::size_t>(std::max(0.0, std::floor(t / slab_)));
}

template <class Visit>
void SpaceTimeGrid::for_each_cell(const Aabb& box, std::size_t slab, const Visit& visit) const {
  const std::int64_t x0 = cell_index(box.min.x(), cell_), x1 = cell_index(box.max.x(), cell_);
  const std::int64_t y0 = cell_index(box.min.y(), cell_), y1 = cell_index(box.max.y(), cell_);
  for (std::int64_t x = x0; x <= x1; ++x) {
    for (std::int64_t y = y0; y <= y1; ++y) {
      visit(combine({slab, static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y)}));
    }
  }
}

void SpaceTimeGrid::file(RobotId robot, std::size_t slab, const Aabb& box) {
  for_each_cell(box, slab, [&](Key key) { cells_[key].push_back(robot); });
}

void SpaceTimeGrid::remove(RobotId robot, std::size_t slab) {
  for_each_cell(boxes_[robot.index()][slab], slab, [&](Key key) {
    const auto cell = cells_.find(key);
    if (cell == cells_.end()) return;
    std::erase(cell->second, robot);
    if (cell->second.empty()) cells_.erase(cell);
  });
}

void SpaceTimeGrid::extend_to(std::size_t slabs) {
  for (std::size_t r = 0; r < boxes_.size(); ++r) {
    std::vector<Aabb>& boxes = boxes_[r];
    while (!boxes.empty() && boxes.size() < slabs) {
      boxes.push_back(boxes.back());
      file({static_cast<std::uint32_t>(r)}, boxes.size() - 1, boxes.back());
    }
  }
  slabs_ = std::max(slabs_, slabs);
}

void SpaceTimeGrid::place(RobotId robot, const Trajectory& path, double from) {
  // The last slab holds nothing but rests, so that extending the grid may repeat it.
  extend_to(slab_of(path.end_time()) + 2);
  std::vector<Aabb>& boxes = boxes_[robot.index()];
  const std::size_t first = std::min(slab_of(from), boxes.size());
  for (std::size_t slab = first; slab < boxes.size(); ++slab) remove(robot, slab);
  boxes.resize(first);
  const Vec3 room = Vec3::Constant(0.5 * world_.required_separation());
  for (std::size_t slab = first; slab < slabs_; ++slab) {
    Aabb box = slab_start(slab) > path.end_time() && slab > first
                   ? boxes.back()
                   : swept(world_, robot, path, slab_start(slab), slab_start(slab + 1));
    if (slab_start(slab) <= path.end_time() || slab == first) {
      box.min -= room;
      box.max += room;
    }
    boxes.push_back(box);
    file(robot, slab, box);
  }
}

void SpaceTimeGrid::begin(std::vector<RobotId>& out) const {
  out.clear();
  ++question_;
}

void SpaceTimeGrid::collect(const Aabb& box, std::size_t slab, std::vector<RobotId>& out) const {
  for_each_cell(box, slab, [&](Key key) {
    const auto cell = cells_.find(key);
    if (cell == cells_.end()) return;
    for (const RobotId other : cell->second) {
      if (added_in_[other.index()] == question_) continue;
      if (!boxes_[other.index()][slab].overlaps(box)) continue;
      added_in_[other.index()] = question_;
      out.push_back(other);
    }
  });
}

void SpaceTimeGrid::neighbours(RobotId robot, std::size_t slab, std::vector<RobotId>& out) const {
  begin(out);
  added_in_[robot.index()] = question_;
  collect(boxes_[robot.index()][slab], slab, out);
  std::ranges::sort(out);
}

void SpaceTimeGrid::within(const Aabb& box, double from, double until,
                           std::vector<RobotId>& out) const {
  begin(out);
  if (slabs_ == 0) return;
  const std::size_t last = slabs_ - 1;
  const std::size_t end = until < slab_start(last) ? slab_of(until) : last;
  for (std::size_t slab = std::min(slab_of(from), last); slab <= end; ++slab) {
    collect(box, slab, out);
  }
  std::ranges::sort(out);
}

}  // namespace accord
