// One robot of a plan against its query, its limits, and everything that stands still. Internal to
// the verifier.
#pragma once

#include <optional>

#include "common/planning/verifier.h"
#include "common/planning/verifier_subject.h"

namespace accord::verification {

// The earliest violation that concerns this robot alone: start, goal, limits, speeds, bounds,
// obstacles, itself. Thread safe.
std::optional<Violation> check_robot(const Subject& subject, RobotId id);

}  // namespace accord::verification
