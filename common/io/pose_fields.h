// Positions and orientations as files write them: x y z, and roll pitch yaw (fixed axes x, y, z in
// this order, as in URDF). Pure functions.
#pragma once

#include <optional>

#include "common/io/fields.h"
#include "common/model/shape.h"

namespace accord {

// Whether everything lies in z = 0. Unknown while the scene's bounds are themselves at fault: then
// checks that depend on it are left out.
enum class Space { kPlanar, kSpatial, kUnknown };

// Exact where roll and pitch are 0: the z axis stays the z axis to the bit.
Pose make_pose(const Vec3& at, const Vec3& rpy);

// From the keys `at` and `rpy`, identity where both are absent. Reports roll or pitch in a planar
// scene. nullopt where a part is at fault: whatever it places is nowhere, so that no other fault
// follows from where it would be without.
std::optional<Pose> read_pose(const Fields& fields, Space space, Faults& faults);

}  // namespace accord
