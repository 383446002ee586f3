#include "worker/lattice.h"

#include <algorithm>
#include <cmath>

namespace accord {
namespace {

using Cell = Eigen::Array<std::int64_t, 3, 1>;

// Lines across an axis, at least `spacing` apart and at most `longest` where that can be, that have
// the most free places on them. (Dynamic programming over a fine grid of positions)
std::vector<double> best_lines(const std::vector<double>& scores, double lower, double fine,
                               std::size_t least, std::size_t most) {
  const std::size_t n = scores.size();
  std::vector<double> best(n);
  std::vector<std::size_t> before(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    best[i] = 0;
    for (std::size_t gap = least; gap <= most && gap <= i; ++gap) {
      if (before[i] == n || best[i - gap] > best[i]) {
        best[i] = best[i - gap];
        before[i] = i - gap;
      }
    }
    best[i] += scores[i];
  }
  std::size_t last = n - 1;
  for (std::size_t i = n; i-- > 0 && i + most >= n;) {
    if (best[i] > best[last]) last = i;
  }
  std::vector<double> lines;
  for (std::size_t i = last; i != n; i = before[i]) lines.push_back(lower + static_cast<double>(i) * fine);
  std::ranges::reverse(lines);
  return lines;
}

}  // namespace

double Lattice::places(const Aabb& box, double spacing, std::size_t dimensions) {
  double places = 1;
  for (std::size_t k = 0; k < dimensions; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    places *= std::floor((box.max[axis] - box.min[axis]) / spacing) + 1;
  }
  return places;
}

Lattice::Lattice(const CollisionWorld& world, RobotId robot, const Aabb& box, double spacing)
    : counts_(Cell::Ones()) {
  const std::size_t dimensions = world.scene().robot(robot).model->dof();
  const auto view = [&](const Vec3& point) { return ConfigurationView(point.data(), dimensions); };
  lay_lines(world, robot, box, spacing);
  std::vector<Cell> cells;  // by node
  nodes_.assign(static_cast<std::size_t>(counts_.prod()), kNone);
  std::size_t index = 0;
  for (std::int64_t z = 0; z < counts_.z(); ++z) {
    for (std::int64_t y = 0; y < counts_.y(); ++y) {
      for (std::int64_t x = 0; x < counts_.x(); ++x, ++index) {
        const Vec3 point(lines_[0][static_cast<std::size_t>(x)], lines_[1][static_cast<std::size_t>(y)],
                         lines_[2][static_cast<std::size_t>(z)]);
        if (!world.is_free(robot, view(point))) continue;
        nodes_[index] = size();
        positions_.push_back(point);
        cells.push_back({x, y, z});
      }
    }
  }
  for (Node node = 0; node < size(); ++node) {
    first_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
    for (std::size_t k = 0; k < dimensions; ++k) {
      for (const std::int64_t step : {-1, 1}) {
        Cell cell = cells[node];
        cell[static_cast<Eigen::Index>(k)] += step;
        const Node other = at(cell);
        if (other == kNone) continue;
        if (!world.motion_is_free(robot, view(positions_[node]), view(positions_[other]))) continue;
        neighbours_.push_back(other);
      }
    }
  }
  first_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
}

void Lattice::lay_lines(const CollisionWorld& world, RobotId robot, const Aabb& box,
                        double spacing) {
  const std::size_t dimensions = world.scene().robot(robot).model->dof();
  constexpr std::size_t kFine = 8, kMost = 10;
  const double fine = spacing / kFine;
  spacing_ = spacing;
  for (std::size_t k = 0; k < 3; ++k) lines_[k] = {0};
  std::vector<std::vector<double>> scores(dimensions);
  Cell fine_counts = Cell::Ones();
  for (std::size_t k = 0; k < dimensions; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    fine_counts[axis] = static_cast<std::int64_t>((box.max[axis] - box.min[axis]) / fine) + 1;
    scores[k].assign(static_cast<std::size_t>(fine_counts[axis]), 0);
  }
  for (std::int64_t z = 0; z < fine_counts.z(); ++z) {
    for (std::int64_t y = 0; y < fine_counts.y(); ++y) {
      for (std::int64_t x = 0; x < fine_counts.x(); ++x) {
        const Cell cell{x, y, z};
        const Vec3 point = box.min + (fine * cell.cast<double>()).matrix();
        if (!world.is_free(robot, ConfigurationView(point.data(), dimensions))) continue;
        for (std::size_t k = 0; k < dimensions; ++k) {
          scores[k][static_cast<std::size_t>(cell[static_cast<Eigen::Index>(k)])] += 1;
        }
      }
    }
  }
  for (std::size_t k = 0; k < dimensions; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    lines_[k] = best_lines(scores[k], box.min[axis], fine, kFine, kMost);
    counts_[axis] = static_cast<std::int64_t>(lines_[k].size());
    for (std::size_t i = 1; i < lines_[k].size(); ++i) {
      spacing_ = std::max(spacing_, lines_[k][i] - lines_[k][i - 1]);
    }
  }
}

Lattice::Node Lattice::at(const Cell& cell) const {
  if ((cell < 0).any() || (cell >= counts_).any()) return kNone;
  return nodes_[static_cast<std::size_t>(cell.x() +
                                         counts_.x() * (cell.y() + counts_.y() * cell.z()))];
}

void Lattice::within(const Vec3& point, double distance, std::vector<Node>& out) const {
  out.clear();
  Cell lower, upper;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    lower[axis] = std::ranges::lower_bound(lines_[k], point[axis] - distance) - lines_[k].begin();
    upper[axis] = std::ranges::upper_bound(lines_[k], point[axis] + distance) - lines_[k].begin();
  }
  for (std::int64_t z = lower.z(); z < upper.z(); ++z) {
    for (std::int64_t y = lower.y(); y < upper.y(); ++y) {
      for (std::int64_t x = lower.x(); x < upper.x(); ++x) {
        const Node node = at({x, y, z});
        if (node == kNone || (positions_[node] - point).norm() > distance) continue;
        out.push_back(node);
      }
    }
  }
  std::ranges::stable_sort(out, {}, [&](Node node) {
    return (positions_[node] - point).squaredNorm();
  });
}

}  // namespace accord
