#include "common/planning/verifier_subject.h"

#include <cmath>

namespace accord::verification {

Vec3 place_of(const Robot& robot, ConfigurationView q) {
  Vec3 local = Vec3::Zero();
  for (std::size_t i = 0; i < robot.model->translations(); ++i) {
    local[static_cast<Eigen::Index>(i)] = q[i];
  }
  return robot.base * local;
}

double travel(const CollisionWorld& world, RobotId id, ConfigurationView a, ConfigurationView b) {
  const std::span<const double> reach = world.reach(id);
  const std::size_t translations = world.scene().robot(id).model->translations();
  double squared = 0;
  for (std::size_t i = 0; i < translations; ++i) squared += (b[i] - a[i]) * (b[i] - a[i]);
  double distance = std::sqrt(squared);
  for (std::size_t i = translations; i < a.size(); ++i) {
    distance += reach[i] * std::abs(b[i] - a[i]);
  }
  return distance;
}

}  // namespace accord::verification
