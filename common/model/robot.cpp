#include "common/model/robot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace accord {

std::size_t RobotModel::translations() const {
  switch (kind) {
    case RobotKind::kDisk:
    case RobotKind::kFootprint:
      return 2;
    case RobotKind::kBall:
      return 3;
    case RobotKind::kArm:
      return 0;
  }
  return 0;
}

void difference(const RobotModel& model, ConfigurationView a, ConfigurationView b,
                std::span<double> out) {
  for (std::size_t i = 0; i < model.dof(); ++i) {
    out[i] = b[i] - a[i];
    if (model.dofs[i].wraps) out[i] = std::remainder(out[i], 2 * std::numbers::pi);
  }
}

void nearest_representation(const RobotModel& model, ConfigurationView a, ConfigurationView b,
                            std::span<double> out) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (std::size_t i = 0; i < model.dof(); ++i) {
    const double turns = model.dofs[i].wraps ? std::round((b[i] - a[i]) / kTurn) : 0;
    out[i] = turns == 0 ? b[i] : b[i] - turns * kTurn;
  }
}

double least_duration(const RobotModel& model, std::span<const double> delta) {
  const std::size_t translations = model.translations();
  double squared = 0;
  for (std::size_t i = 0; i < translations; ++i) squared += delta[i] * delta[i];
  double duration = translations > 0 ? std::sqrt(squared) / model.speed : 0.0;
  for (std::size_t i = translations; i < model.dof(); ++i) {
    duration = std::max(duration, std::abs(delta[i]) / model.dofs[i].velocity);
  }
  return duration * (1 + kSpeedMargin);
}

}  // namespace accord
