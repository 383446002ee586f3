#include "common/planning/verifier_path_boxes.h"

#include <algorithm>

namespace accord::verification {

PathBoxes::PathBoxes(const CollisionWorld& world, RobotId robot, const Trajectory& path)
    : world_(world), robot_(robot), path_(path) {
  constexpr std::size_t kFewWaypoints = 3;  // whose motions are always asked for in parts
  if (path.size() <= kFewWaypoints) return;
  std::vector<Aabb>& motions = levels_.emplace_back();
  motions.reserve(path.size() - 1);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    motions.push_back(world.swept_bounds(robot, path.configuration(i), path.configuration(i + 1)));
  }
  while (levels_.back().size() > 1) {
    const std::vector<Aabb>& below = levels_.back();
    std::vector<Aabb> level(below.size() / 2);
    for (std::size_t i = 0; i < level.size(); ++i) {
      level[i] = below[2 * i];
      level[i].merge(below[2 * i + 1]);
    }
    levels_.push_back(std::move(level));
  }
}

Aabb PathBoxes::over(double t0, double t1) const {
  thread_local Configuration from, to;
  from.resize(path_.dof());
  to.resize(path_.dof());
  path_.at(t0, from);
  const std::size_t first = path_.segment_at(t0);
  const std::size_t after = first + 1;
  if (after >= path_.size()) return world_.swept_bounds(robot_, from, from);
  path_.at(t1, to);
  if (t1 <= path_.time(after)) return world_.swept_bounds(robot_, from, to);
  // The last waypoint before t1.
  const auto& times = path_.times();
  const auto last = static_cast<std::size_t>(
      std::lower_bound(times.begin() + static_cast<std::ptrdiff_t>(after), times.end(), t1) -
      times.begin() - 1);
  Aabb box = world_.swept_bounds(robot_, from, path_.configuration(after));
  if (last + 1 < path_.size()) {
    box.merge(world_.swept_bounds(robot_, path_.configuration(last), to));
  }
  if (last > after) box.merge(between(after, last));
  return box;
}

Aabb PathBoxes::between(std::size_t first, std::size_t last) const {
  if (levels_.empty()) {
    return world_.swept_bounds(robot_, path_.configuration(first), path_.configuration(last));
  }
  Aabb box = levels_[0][first];
  // From both ends towards the middle: each level's odd ones out, and on in pairs.
  for (std::size_t level = 0; first < last; ++level, first /= 2, last /= 2) {
    if (first % 2 == 1) box.merge(levels_[level][first++]);
    if (last % 2 == 1) box.merge(levels_[level][--last]);
  }
  return box;
}

}  // namespace accord::verification
