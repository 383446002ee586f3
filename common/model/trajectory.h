// One robot's timed path in its configuration space: linear in q between successive waypoints, in
// the numbers as written; parked at the last one ever after (and at the first before its time).
#pragma once

#include <cstddef>
#include <vector>

#include "common/model/configuration.h"

namespace accord {

class Trajectory {
 public:
  Trajectory() = default;
  explicit Trajectory(std::size_t dof) : dof_(dof) {}

  // Requires: q.size() == dof(), t greater than end_time() unless empty.
  void append(double t, ConfigurationView q);
  void reserve(std::size_t waypoints);

  std::size_t dof() const { return dof_; }
  std::size_t size() const { return times_.size(); }  // waypoints
  bool empty() const { return times_.empty(); }
  double time(std::size_t i) const { return times_[i]; }
  const std::vector<double>& times() const { return times_; }
  ConfigurationView configuration(std::size_t i) const {
    return {configurations_.data() + i * dof_, dof_};
  }
  double start_time() const { return times_.front(); }
  double end_time() const { return times_.back(); }

  // Index of the last waypoint with time <= t; 0 for earlier t. Requires: not empty.
  std::size_t segment_at(double t) const;

  // Writes the configuration at time t into out. Requires: not empty.
  void at(double t, std::span<double> out) const;
  Configuration at(double t) const;

  // The time at which the robot reaches its last configuration for good: trailing waypoints that
  // repeat it do not count.
  double arrival_time() const;

  // Without trailing and inner waypoints that add nothing: repeats at the end, and the inner
  // waypoints of a wait.
  Trajectory tidied() const;

  friend bool operator==(const Trajectory&, const Trajectory&) = default;

 private:
  std::size_t dof_ = 0;
  std::vector<double> times_;
  std::vector<double> configurations_;  // size() x dof(), row by row
};

}  // namespace accord
