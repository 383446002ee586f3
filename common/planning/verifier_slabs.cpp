#include "common/planning/verifier_slabs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace accord::verification {
namespace {

// Enough for hours of motion; more would only cost memory for the slabs' results.
constexpr double kMostSlabs = 20000;
constexpr double kWaypointsPerSlab = 4;

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
  return pairs;
}

}  // namespace

TimeSlabs::TimeSlabs(const Subject& subject) : subject_(subject), end_(subject.end()) {
  if (end_ <= 0) end_ = 1;  // nobody moves; any stretch of time shows it
  double travelled = 0;
  double sizes = 0;
  double waypoints = 0;
  boxes_.reserve(subject.robots());
  for (std::uint32_t r = 0; r < subject.robots(); ++r) {
    const Trajectory& path = subject.path(RobotId{r});
    boxes_.emplace_back(subject.world, RobotId{r}, path);
    waypoints += static_cast<double>(path.size());
    const ConfigurationView rest = path.configuration(0);
    sizes += size_of(subject.world.swept_bounds(RobotId{r}, rest, rest));
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      travelled +=
          travel(subject.world, RobotId{r}, path.configuration(i), path.configuration(i + 1));
    }
  }
  const double each = waypoints / static_cast<double>(subject.robots());
  count_ = static_cast<std::size_t>(std::clamp(each / kWaypointsPerSlab, 1.0, kMostSlabs));
  // No further than to parts in which a robot moves about its own size, on average.
  const double sizes_per_slab = travelled / std::max(sizes, 1e-9) / static_cast<double>(count_);
  halvings_ = static_cast<unsigned>(std::ceil(std::log2(std::clamp(sizes_per_slab, 1.0, 1e6))));
}

double TimeSlabs::begin(std::size_t slab) const {
  return slab == count_ ? end_ : end_ * static_cast<double>(slab) / static_cast<double>(count_);
}

void TimeSlabs::for_each_part(std::size_t slab, double distance, const Visit& visit) const {
  const double from = begin(slab), until = begin(slab + 1);
  Pairs pairs = near_pairs(from, until, distance);
  descend(from, until, halvings_, pairs, distance, visit);
}

// An estimate of how many stretches on which both robots move linearly the pairs have.
double TimeSlabs::looks(const Pairs& pairs, double begin, double end) const {
  double sum = 0;
  const auto waypoints = [&](RobotId robot) {
    const auto& times = subject_.path(robot).times();
    const auto first = std::ranges::upper_bound(times, begin);
    return static_cast<double>(std::lower_bound(first, times.end(), end) - first);
  };
  // Every so many pairs stand for all.
  const std::size_t step = 1 + pairs.size() / 64;
  for (std::size_t i = 0; i < pairs.size(); i += step) {
    sum += static_cast<double>(step) * (1 + waypoints(pairs[i].first) + waypoints(pairs[i].second));
  }
  return sum;
}

// To box what a robot sweeps costs about as much as a look at a pair.
bool TimeSlabs::descend(double begin, double end, unsigned halvings, Pairs& pairs, double distance,
                        const Visit& visit) const {
  constexpr double kFew = 0.5, kMany = 300;  // looks a robot
  const auto robots = static_cast<double>(subject_.robots());
  const double middle = 0.5 * (begin + end);
  const double whole = looks(pairs, begin, end);
  if (halvings == 0 || whole <= kFew * robots || !(begin < middle && middle < end)) {
    return visit(begin, end, pairs);
  }
  Pairs before = still_near(pairs, begin, middle, distance);
  Pairs after = still_near(pairs, middle, end, distance);
  const double parts = looks(before, begin, middle) + looks(after, middle, end);
  if (whole <= kMany * robots && parts + robots >= whole) return visit(begin, end, pairs);
  pairs = {};  // memory that is not needed further down
  return descend(begin, middle, halvings - 1, before, distance, visit) &&
         descend(middle, end, halvings - 1, after, distance, visit);
}

TimeSlabs::Pairs TimeSlabs::near_pairs(double begin, double end, double distance) const {
  std::vector<Aabb> boxes;
  boxes.reserve(boxes_.size());
  for (const PathBoxes& path : boxes_) {
    boxes.push_back(inflated(path.over(begin, end), distance / 2));
  }
  return overlapping(boxes);
}

TimeSlabs::Pairs TimeSlabs::still_near(const Pairs& pairs, double begin, double end,
                                       double distance) const {
  std::vector<Aabb> boxes(boxes_.size());
  std::vector<char> has_box(boxes_.size(), 0);
  const auto box = [&](RobotId robot) -> const Aabb& {
    Aabb& own = boxes[robot.index()];
    if (!has_box[robot.index()]) {
      own = inflated(boxes_[robot.index()].over(begin, end), distance / 2);
      has_box[robot.index()] = 1;
    }
    return own;
  };
  Pairs near;
  for (const Pair pair : pairs) {
    if (box(pair.first).overlaps(box(pair.second))) near.push_back(pair);
  }
  return near;
}

}  // namespace accord::verification
