#include "common/model/trajectory.h"

#include <algorithm>
#include <cassert>

namespace accord {

void Trajectory::append(double t, ConfigurationView q) {
  assert(q.size() == dof_);
  assert(times_.empty() || t > times_.back());
  times_.push_back(t);
  configurations_.insert(configurations_.end(), q.begin(), q.end());
}

void Trajectory::reserve(std::size_t waypoints) {
  times_.reserve(waypoints);
  configurations_.reserve(waypoints * dof_);
}

std::size_t Trajectory::segment_at(double t) const {
  const auto after = std::upper_bound(times_.begin(), times_.end(), t);
  return after == times_.begin() ? 0 : static_cast<std::size_t>(after - times_.begin()) - 1;
}

void Trajectory::at(double t, std::span<double> out) const {
  const std::size_t i = segment_at(t);
  const ConfigurationView from = configuration(i);
  if (t <= times_[i] || i + 1 == size()) {
    std::copy(from.begin(), from.end(), out.begin());
    return;
  }
  const ConfigurationView to = configuration(i + 1);
  const double s = (t - times_[i]) / (times_[i + 1] - times_[i]);
  for (std::size_t k = 0; k < dof_; ++k) out[k] = from[k] + s * (to[k] - from[k]);
}

Configuration Trajectory::at(double t) const {
  Configuration q(dof_);
  at(t, q);
  return q;
}

double Trajectory::arrival_time() const {
  std::size_t i = size() - 1;
  while (i > 0 && std::ranges::equal(configuration(i - 1), configuration(size() - 1))) --i;
  return times_[i];
}

Trajectory Trajectory::tidied() const {
  Trajectory out(dof_);
  const double arrival = arrival_time();
  for (std::size_t i = 0; i < size() && times_[i] <= arrival; ++i) {
    const bool inner = i > 0 && i + 1 < size() && times_[i] < arrival;
    if (inner && std::ranges::equal(configuration(i - 1), configuration(i)) &&
        std::ranges::equal(configuration(i), configuration(i + 1))) {
      continue;
    }
    out.append(times_[i], configuration(i));
  }
  return out;
}

}  // namespace accord
