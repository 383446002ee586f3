#include "common/planning/splice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace accord {

double append_apart(double t, ConfigurationView q, Trajectory& path) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double end = path.end_time();
  t = std::max({t, end + kSameInstant, std::nextafter(end, kInfinity)});
  path.append(t, q);
  return t;
}

void append_tail(const RobotModel& model, const Trajectory& old, double cut, Trajectory& path) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const Configuration left = old.at(cut);
  double shift = path.end_time() - cut;
  Configuration q(old.dof()), turns(old.dof(), 0.0);
  const ConfigurationView reached = path.configuration(path.size() - 1);
  for (std::size_t k = 0; k < q.size(); ++k) {
    if (model.dofs[k].wraps) turns[k] = kTurn * std::round((reached[k] - left[k]) / kTurn);
  }
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (old.time(i) <= cut + kSameInstant) continue;
    for (std::size_t k = 0; k < q.size(); ++k) q[k] = old.configuration(i)[k] + turns[k];
    shift = append_apart(old.time(i) + shift, q, path) - old.time(i);
  }
}

}  // namespace accord
