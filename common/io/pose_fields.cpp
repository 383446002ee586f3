#include "common/io/pose_fields.h"

#include <cmath>

namespace accord {

Pose make_pose(const Vec3& at, const Vec3& rpy) {
  const Vec3 c = rpy.array().cos();
  const Vec3 s = rpy.array().sin();
  Eigen::Matrix3d rotation;
  rotation << c.z() * c.y(), c.z() * s.y() * s.x() - s.z() * c.x(),
      c.z() * s.y() * c.x() + s.z() * s.x(),  //
      s.z() * c.y(), s.z() * s.y() * s.x() + c.z() * c.x(),
      s.z() * s.y() * c.x() - c.z() * s.x(),  //
      -s.y(), c.y() * s.x(), c.y() * c.x();
  Pose pose = Pose::Identity();
  pose.linear() = rotation;
  pose.translation() = at;
  return pose;
}

std::optional<Pose> read_pose(const Fields& fields, Space space, Faults& faults) {
  const std::size_t before = faults.count();
  Vec3 at = Vec3::Zero();
  Vec3 rpy = Vec3::Zero();
  if (const auto value = fields.find("at")) {
    const auto numbers =
        read_numbers(*value, {2, 3}, "[x, y] or [x, y, z]", kCoordinateRange, faults);
    if (numbers) at = {(*numbers)[0], (*numbers)[1], numbers->size() > 2 ? (*numbers)[2] : 0.0};
  }
  if (const auto value = fields.find("rpy")) {
    const auto numbers = read_numbers(*value, {3}, "[roll, pitch, yaw]", kAngleRange, faults);
    if (numbers) rpy = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    if (space == Space::kPlanar && (rpy.x() != 0 || rpy.y() != 0)) {
      fault_at(*value, "roll and pitch must be 0 in a planar scene: they turn out of its plane",
               faults);
    }
  }
  if (faults.count() != before) return std::nullopt;
  return make_pose(at, rpy);
}

}  // namespace accord
