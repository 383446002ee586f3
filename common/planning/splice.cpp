#include "common/planning/splice.h"

#include <cmath>
#include <numbers>

namespace accord {

void append_tail(const RobotModel& model, const Trajectory& old, double cut, Trajectory& path) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const Configuration left = old.at(cut);
  const double shift = path.end_time() - cut;
  Configuration q(old.dof()), turns(old.dof(), 0.0);
  const ConfigurationView reached = path.configuration(path.size() - 1);
  for (std::size_t k = 0; k < q.size(); ++k) {
    if (model.dofs[k].wraps) turns[k] = kTurn * std::round((reached[k] - left[k]) / kTurn);
  }
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (old.time(i) <= cut + kSameInstant) continue;
    for (std::size_t k = 0; k < q.size(); ++k) q[k] = old.configuration(i)[k] + turns[k];
    path.append(old.time(i) + shift, q);
  }
}

}  // namespace accord
