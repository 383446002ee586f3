// shorten_alone() of path_planner.h.
#include <algorithm>

#include "common/planning/random.h"
#include "worker/path_planner.h"

namespace accord {
namespace {

constexpr int kMostCuts = 80;
constexpr int kFailuresInARow = 16;

using Path = std::vector<Configuration>;

double length(const RobotModel& model, const Configuration& a, const Configuration& b) {
  Configuration delta(a.size());
  for (std::size_t k = 0; k < delta.size(); ++k) delta[k] = b[k] - a[k];
  return least_duration(model, delta);
}

class Shortener {
 public:
  Shortener(const CollisionWorld& world, RobotId robot, Path& path, Effort& effort)
      : world_(world),
        robot_(robot),
        model_(*world.scene().robot(robot).model),
        path_(path),
        effort_(effort) {}

  // From each kept waypoint to the furthest one that halving the way ahead finds in reach.
  void skip_waypoints() {
    Path kept{path_.front()};
    for (std::size_t i = 0; i + 1 < path_.size();) {
      std::size_t j = path_.size() - 1;
      while (j > i + 1 && !is_free(path_[i], path_[j])) j = i + (j - i + 1) / 2;
      kept.push_back(path_[j]);
      i = j;
    }
    path_ = std::move(kept);
  }

  void cut_corners(std::uint64_t seed) {
    RandomStream random(seed);
    for (int cut = 0, failures = 0; cut < kMostCuts && failures < kFailuresInARow; ++cut) {
      if (path_.size() < 3) return;
      failures = try_cut(random) ? 0 : failures + 1;
    }
  }

 private:
  struct Place {
    std::size_t segment;  // between waypoints segment and segment + 1
    Configuration q;
  };

  bool is_free(const Configuration& a, const Configuration& b) {
    ++effort_.motion_checks;
    return world_.motion_is_free(robot_, a, b);
  }

  Place place_at(double along) const {
    std::size_t i = 0;
    double part = length(model_, path_[0], path_[1]);
    while (i + 2 < path_.size() && along > part) {
      along -= part;
      ++i;
      part = length(model_, path_[i], path_[i + 1]);
    }
    const double s = part > 0 ? std::clamp(along / part, 0.0, 1.0) : 0;
    Configuration q(path_[i].size());
    for (std::size_t k = 0; k < q.size(); ++k) {
      q[k] = path_[i][k] + s * (path_[i + 1][k] - path_[i][k]);
    }
    return {i, std::move(q)};
  }

  // Joins two places of the path straight, if that is free and shorter.
  bool try_cut(RandomStream& random) {
    double total = 0;
    for (std::size_t i = 1; i < path_.size(); ++i) total += length(model_, path_[i - 1], path_[i]);
    double from = random.uniform(0, total), to = random.uniform(0, total);
    if (from > to) std::swap(from, to);
    Place a = place_at(from), b = place_at(to);
    if (a.segment == b.segment) return false;
    if (length(model_, a.q, b.q) > 0.9999 * (to - from) || !is_free(a.q, b.q)) return false;
    const auto begin = path_.begin() + static_cast<std::ptrdiff_t>(a.segment) + 1;
    const auto end = path_.begin() + static_cast<std::ptrdiff_t>(b.segment) + 1;
    const auto place = path_.erase(begin, end);
    path_.insert(path_.insert(place, std::move(b.q)), std::move(a.q));
    return true;
  }

  const CollisionWorld& world_;
  RobotId robot_;
  const RobotModel& model_;
  Path& path_;
  Effort& effort_;
};

}  // namespace

void shorten_alone(const CollisionWorld& world, RobotId robot, std::uint64_t seed, Path& path,
                   Effort& effort) {
  if (path.size() < 3) return;
  Shortener shortener(world, robot, path, effort);
  shortener.skip_waypoints();
  shortener.cut_corners(seed);
  shortener.skip_waypoints();
}

}  // namespace accord
