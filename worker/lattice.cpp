#include "worker/lattice.h"

#include <algorithm>
#include <cmath>

namespace accord {
namespace {

// Lines are laid on multiples of this share of their least distance, and at most so many of these
// apart: wide enough for a rack's aisles to get their lines whatever the racks measure.
constexpr std::size_t kShares = 8;
constexpr std::size_t kMostShares = 10;
// Free space is measured on this share of the least distance.
constexpr double kProbes = 0.5;

// Of all ways to lay lines on positions with these scores, each `least` to `most` positions from
// the next, and none left out at either end, the one with the greatest sum. (Dynamic programming)
std::vector<std::size_t> best_lines(const std::vector<double>& scores, std::size_t least,
                                    std::size_t most) {
  const std::size_t n = scores.size();
  std::vector<double> best(n);            // sum up to here, with a line here
  std::vector<std::size_t> before(n, n);  // the line before; n: none
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t gap = least; gap <= std::min(most, i); ++gap) {
      if (before[i] == n || best[i - gap] > best[before[i]]) before[i] = i - gap;
    }
    best[i] = scores[i] + (before[i] == n ? 0 : best[before[i]]);
  }
  std::size_t last = n - 1;
  for (std::size_t back = 1; back < std::min(least, n); ++back) {
    if (best[n - 1 - back] > best[last]) last = n - 1 - back;
  }
  std::vector<std::size_t> lines;
  for (std::size_t i = last; i != n; i = before[i]) lines.push_back(i);
  std::ranges::reverse(lines);
  return lines;
}

}  // namespace

double Lattice::places(const Aabb& box, double least, std::size_t dimensions) {
  double places = 1;
  for (std::size_t k = 0; k < dimensions; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    places *= std::floor((box.max[axis] - box.min[axis]) / least) + 1;
  }
  return places;
}

template <class Visit>
void Lattice::for_each(const Index& lower, const Index& upper, const Visit& visit) {
  Index index;
  for (index[2] = lower[2]; index[2] < upper[2]; ++index[2]) {
    for (index[1] = lower[1]; index[1] < upper[1]; ++index[1]) {
      for (index[0] = lower[0]; index[0] < upper[0]; ++index[0]) visit(index);
    }
  }
}

Lattice::Lattice(const CollisionWorld& world, RobotId robot, const Aabb& box, double least) {
  lay_lines(world, robot, box, least);
  const std::size_t dof = world.scene().robot(robot).model->dof();
  const Index all{lines_[0].size(), lines_[1].size(), lines_[2].size()};
  nodes_.assign(all[0] * all[1] * all[2], kNone);
  std::vector<Index> indices;  // by node
  for_each({0, 0, 0}, all, [&](const Index& index) {
    const Vec3 point = crossing(index);
    if (!world.is_free(robot, {point.data(), dof})) return;
    nodes_[cell(index)] = size();
    positions_.push_back(point);
    indices.push_back(index);
  });
  for (Node node = 0; node < size(); ++node) {
    first_.push_back(neighbours_.size());
    const Vec3& from = positions_[node];
    for (std::size_t axis = 0; axis < dof; ++axis) {
      for (const bool up : {false, true}) {
        Index index = indices[node];
        if (index[axis] == (up ? all[axis] - 1 : 0)) continue;
        index[axis] += up ? 1 : std::size_t(-1);
        const Node other = nodes_[cell(index)];
        if (other == kNone) continue;
        const Vec3& to = positions_[other];
        if (!world.motion_is_free(robot, {from.data(), dof}, {to.data(), dof})) continue;
        neighbours_.push_back(other);
      }
    }
  }
  first_.push_back(neighbours_.size());
}

void Lattice::lay_lines(const CollisionWorld& world, RobotId robot, const Aabb& box, double least) {
  const std::size_t dof = world.scene().robot(robot).model->dof();
  lines_.fill({0});
  spacing_ = least;
  for (std::size_t axis = 0; axis < dof; ++axis) {
    std::array<double, 3> step{};
    Index counts{1, 1, 1};
    for (std::size_t k = 0; k < dof; ++k) {
      step[k] = least * (k == axis ? 1.0 / kShares : kProbes);
      const auto i = static_cast<Eigen::Index>(k);
      counts[k] = static_cast<std::size_t>((box.max[i] - box.min[i]) / step[k]) + 1;
    }
    std::vector<double> scores(counts[axis], 0);
    for_each({0, 0, 0}, counts, [&](const Index& index) {
      Vec3 point = Vec3::Zero();
      for (std::size_t k = 0; k < dof; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        point[i] = box.min[i] + static_cast<double>(index[k]) * step[k];
      }
      if (world.is_free(robot, {point.data(), dof})) scores[index[axis]] += 1;
    });
    std::vector<double>& lines = lines_[axis];
    lines.clear();
    for (const std::size_t line : best_lines(scores, kShares, kMostShares)) {
      const double at =
          box.min[static_cast<Eigen::Index>(axis)] + static_cast<double>(line) * step[axis];
      if (!lines.empty()) spacing_ = std::max(spacing_, at - lines.back());
      lines.push_back(at);
    }
  }
}

void Lattice::within(const Vec3& point, double distance, std::vector<Node>& out) const {
  out.clear();
  Index lower, upper;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double>& lines = lines_[axis];
    const double at = point[static_cast<Eigen::Index>(axis)];
    lower[axis] =
        static_cast<std::size_t>(std::ranges::lower_bound(lines, at - distance) - lines.begin());
    upper[axis] =
        static_cast<std::size_t>(std::ranges::upper_bound(lines, at + distance) - lines.begin());
  }
  for_each(lower, upper, [&](const Index& index) {
    const Node node = nodes_[cell(index)];
    if (node != kNone && (positions_[node] - point).norm() <= distance) out.push_back(node);
  });
  std::ranges::stable_sort(out, {},
                           [&](Node node) { return (positions_[node] - point).squaredNorm(); });
}

}  // namespace accord
