#include "worker/team.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace accord {
namespace {

void intersect(const std::vector<Interval>& a, const std::vector<Interval>& b,
               std::vector<Interval>& out) {
  out.clear();
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double lo = std::max(a[i].lo, b[j].lo), hi = std::min(a[i].hi, b[j].hi);
    if (lo <= hi) out.push_back({lo, hi});
    (a[i].hi < b[j].hi ? i : j) += 1;
  }
}

}  // namespace

Team::Team(const CollisionWorld& world, std::vector<RobotId> members, double from)
    : world_(world), members_(std::move(members)) {
  offsets_.push_back(0);
  for (const RobotId member : members_) {
    const RobotModel& model = *world.scene().robot(member).model;
    const auto reach = world.reach(member);
    weights_.insert(weights_.end(), reach.begin(), reach.end());
    for (const DegreeOfFreedom& dof : model.dofs) wraps_.push_back(dof.wraps ? 1 : 0);
    offsets_.push_back(offsets_.back() + model.dof());
    obstacles_.emplace_back(world, member, from);
  }
  dof_ = offsets_.back();
  delta_.resize(dof_);
}

void Team::avoid(RobotId other, const Trajectory& path, double until) {
  for (MovingObstacles& obstacles : obstacles_) obstacles.add(other, path, until);
}

void Team::avoid(const PointTraffic& traffic, const std::vector<char>* only) {
  for (MovingObstacles& obstacles : obstacles_) obstacles.add(traffic, only);
}

void Team::avoid_outsiders(const Subproblem& subproblem) {
  for (const Outsider& outsider : subproblem.outsiders) {
    avoid(outsider.robot, outsider.path, outsider.until);
  }
}

bool Team::is_free(ConfigurationView q) const {
  for (std::size_t i = 0; i < size(); ++i) {
    if (!world_.is_free(members_[i], part(q, i))) return false;
  }
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = i + 1; j < size(); ++j) {
      if (!world_.are_clear(members_[i], part(q, i), members_[j], part(q, j))) return false;
    }
  }
  return true;
}

bool Team::is_free_beside(ConfigurationView q, std::size_t i) const {
  if (!world_.is_free(members_[i], part(q, i))) return false;
  for (std::size_t j = 0; j < i; ++j) {
    if (!world_.are_clear(members_[i], part(q, i), members_[j], part(q, j))) return false;
  }
  return true;
}

bool Team::motion_is_free(ConfigurationView a, ConfigurationView b) const {
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = i + 1; j < size(); ++j) {
      if (!world_.motions_are_clear(members_[i], part(a, i), part(b, i), members_[j], part(a, j),
                                    part(b, j))) {
        return false;
      }
    }
  }
  for (std::size_t i = 0; i < size(); ++i) {
    if (!world_.motion_is_free(members_[i], part(a, i), part(b, i))) return false;
  }
  return true;
}

double Team::duration(ConfigurationView a, ConfigurationView b) const {
  double longest = 0;
  for (std::size_t k = 0; k < dof_; ++k) delta_[k] = b[k] - a[k];
  for (std::size_t i = 0; i < size(); ++i) {
    longest = std::max(longest,
                       least_duration(*world_.scene().robot(members_[i]).model, part(delta_, i)));
  }
  return longest;
}

double Team::squared_distance(ConfigurationView a, ConfigurationView b) const {
  double sum = 0;
  for (std::size_t k = 0; k < dof_; ++k) {
    double delta = b[k] - a[k];
    if (wraps_[k]) delta = std::remainder(delta, 2 * std::numbers::pi);
    sum += weights_[k] * delta * (weights_[k] * delta);
  }
  return sum;
}

void Team::nearest_representation(ConfigurationView a, ConfigurationView b,
                                  std::span<double> out) const {
  for (std::size_t i = 0; i < size(); ++i) {
    accord::nearest_representation(*world_.scene().robot(members_[i]).model, part(a, i), part(b, i),
                                   out.subspan(offsets_[i], offsets_[i + 1] - offsets_[i]));
  }
}

void Team::safe_intervals(ConfigurationView q, double since, std::vector<Interval>& out,
                          const std::optional<MovingBody::Name>& name) {
  obstacles_[0].safe_intervals(part(q, 0), since, name, out);
  for (std::size_t i = 1; i < size(); ++i) {
    obstacles_[i].safe_intervals(part(q, i), since, name, other_);
    intersect(out, other_, merged_);
    out.swap(merged_);
  }
}

bool Team::motion_is_clear(ConfigurationView a, ConfigurationView b, double t, double duration) {
  for (std::size_t i = 0; i < size(); ++i) {
    if (!obstacles_[i].motion_is_clear(part(a, i), part(b, i), t, duration)) return false;
  }
  return true;
}

bool Team::avoids_points() const {
  return std::ranges::all_of(obstacles_, &MovingObstacles::is_of_points);
}

std::uint64_t Team::checks() const {
  std::uint64_t sum = 0;
  for (const MovingObstacles& obstacles : obstacles_) sum += obstacles.checks();
  return sum;
}

std::optional<double> Team::earliest_departure(ConfigurationView a, ConfigurationView b,
                                               double duration, double lo, double hi) {
  double t = lo;
  for (std::size_t agreed = 0, i = 0; agreed < size(); i = (i + 1) % size()) {
    const auto departure =
        obstacles_[i].earliest_departure(part(a, i), part(b, i), duration, t, hi);
    if (!departure) return std::nullopt;
    agreed = *departure == t ? agreed + 1 : 1;
    t = *departure;
  }
  return t;
}

}  // namespace accord
