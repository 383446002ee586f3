#include "coordinator/space_time_grid.h"

#include <algorithm>
#include <cmath>

namespace accord {
namespace {

// Along each axis; beyond, cells are larger than asked for.
constexpr double kMostCells = 256;

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

SpaceTimeGrid::Axis::Axis(double low_end, double high_end, double cell)
    : low(low_end), per_metre(0), cells(1) {
  const double span = high_end - low_end;
  const double wanted = std::clamp(std::floor(span / cell), 1.0, kMostCells);
  cells = static_cast<std::size_t>(wanted);
  if (span > 0) per_metre = wanted / span;
}

std::size_t SpaceTimeGrid::Axis::index(double x) const {
  const double cell = (x - low) * per_metre;
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(cells - 1)));
}

SpaceTimeGrid::SpaceTimeGrid(const CollisionWorld& world, double slab, const Aabb& area,
                             double cell)
    : world_(world),
      slab_(slab),
      columns_(area.min.x(), area.max.x(), cell),
      rows_(area.min.y(), area.max.y(), cell),
      boxes_(world.scene().robots.size()),
      added_in_(world.scene().robots.size(), 0) {}

std::size_t SpaceTimeGrid::slab_of(double t) const {
  return static_cast<std::size_t>(std::max(0.0, std::floor(t / slab_)));
}

template <class Visit>
void SpaceTimeGrid::for_each_cell(const Aabb& box, std::size_t slab, const Visit& visit) const {
  const std::size_t x0 = columns_.index(box.min.x()), x1 = columns_.index(box.max.x());
  const std::size_t y0 = rows_.index(box.min.y()), y1 = rows_.index(box.max.y());
  for (std::size_t y = y0; y <= y1; ++y) {
    const std::size_t row = (slab * rows_.cells + y) * columns_.cells;
    for (std::size_t x = x0; x <= x1; ++x) visit(row + x);
  }
}

void SpaceTimeGrid::file(RobotId robot, std::size_t slab, const Aabb& box) {
  for_each_cell(box, slab, [&](std::size_t cell) { cells_[cell].push_back({robot, box}); });
}

void SpaceTimeGrid::remove(RobotId robot, std::size_t slab) {
  for_each_cell(boxes_[robot.index()][slab], slab, [&](std::size_t cell) {
    std::vector<Filed>& filed = cells_[cell];
    const auto found = std::ranges::find(filed, robot, &Filed::robot);
    *found = filed.back();
    filed.pop_back();
  });
}

void SpaceTimeGrid::extend_to(std::size_t slabs) {
  if (slabs <= slabs_) return;
  slabs_ = slabs;
  cells_.resize(slabs * rows_.cells * columns_.cells);
  for (std::size_t r = 0; r < boxes_.size(); ++r) {
    std::vector<Aabb>& boxes = boxes_[r];
    while (!boxes.empty() && boxes.size() < slabs) {
      boxes.push_back(boxes.back());
      file({static_cast<std::uint32_t>(r)}, boxes.size() - 1, boxes.back());
    }
  }
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
  for_each_cell(box, slab, [&](std::size_t cell) {
    for (const Filed& other : cells_[cell]) {
      if (!other.box.overlaps(box) || added_in_[other.robot.index()] == question_) continue;
      added_in_[other.robot.index()] = question_;
      out.push_back(other.robot);
    }
  });
}

void SpaceTimeGrid::neighbours(RobotId robot, std::size_t slab, std::vector<RobotId>& out) const {
  begin(out);
  added_in_[robot.index()] = question_;
  collect(boxes_[robot.index()][slab], slab, out);
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
