#include "common/planning/verifier_slabs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace accord::verification {
namespace {

// Enough for hours of motion; more would only cost memory for the slabs' results.
constexpr double kMaxSlabs = 20000;

double size_of(const Aabb& box) {
  return (box.max - box.min).maxCoeff();
}

Aabb inflated(Aabb box, double by) {
  box.min.array() -= by;
  box.max.array() += by;
  return box;
}

// The axis along which the boxes' lower corners are spread the widest.
Eigen::Index sweep_axis(const std::vector<Aabb>& boxes) {
  Vec3 low = boxes.front().min;
  Vec3 high = low;
  for (const Aabb& box : boxes) {
    low = low.cwiseMin(box.min);
    high = high.cwiseMax(box.min);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  return axis;
}

// Sort and sweep (Baraff 1992) along one axis.
std::vector<Pair> overlapping(const std::vector<Aabb>& boxes) {
  std::vector<Pair> pairs;
  if (boxes.empty()) return pairs;
  const Eigen::Index axis = sweep_axis(boxes);
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return boxes[i].min[axis]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Aabb& box = boxes[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (boxes[order[j]].min[axis] > box.max[axis]) break;
      if (!box.overlaps(boxes[order[j]])) continue;
      pairs.push_back(
          {RobotId{std::min(order[i], order[j])}, RobotId{std::max(order[i], order[j])}});
    }
  }
  std::ranges::sort(pairs, [](const Pair& a, const Pair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  return pairs;
}

}  // namespace

TimeSlabs::TimeSlabs(const Subject& subject) : subject_(subject), end_(subject.end()) {
  if (end_ <= 0) end_ = 1;  // nobody moves; any stretch of time shows it
  double travelled = 0;
  double sizes = 0;
  for (std::uint32_t r = 0; r < subject.robots(); ++r) {
    const Trajectory& path = subject.path(RobotId{r});
    const ConfigurationView rest = path.configuration(0);
    sizes += size_of(subject.world.swept_bounds(RobotId{r}, rest, rest));
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      travelled +=
          travel(subject.world, RobotId{r}, path.configuration(i), path.configuration(i + 1));
    }
  }
  const double slabs = sizes > 0 ? std::ceil(travelled / sizes) : 1;
  count_ = static_cast<std::size_t>(std::clamp(slabs, 1.0, kMaxSlabs));
}

double TimeSlabs::begin(std::size_t slab) const {
  return end_ * static_cast<double>(slab) / static_cast<double>(count_);
}

double TimeSlabs::end(std::size_t slab) const {
  return slab + 1 == count_ ? end_ : begin(slab + 1);
}

std::vector<Pair> TimeSlabs::near_pairs(std::size_t slab, double distance) const {
  std::vector<Aabb> boxes;
  boxes.reserve(subject_.robots());
  for (std::uint32_t r = 0; r < subject_.robots(); ++r) {
    boxes.push_back(inflated(swept_box(RobotId{r}, begin(slab), end(slab)), distance / 2));
  }
  return overlapping(boxes);
}

Aabb TimeSlabs::swept_box(RobotId id, double t0, double t1) const {
  const Trajectory& path = subject_.path(id);
  Configuration from = path.at(t0);
  Configuration to(path.dof());
  Aabb box = subject_.world.swept_bounds(id, from, from);
  if (t0 >= path.end_time()) return box;
  for_each_stretch(path, path, t0, t1, [&](double, double until) {
    path.at(until, to);
    box.merge(subject_.world.swept_bounds(id, from, to));
    from.swap(to);
    return true;
  });
  return box;
}

}  // namespace accord::verification
