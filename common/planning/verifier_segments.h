// What has to hold of a plan's segments, which say in what company of robots, and by which solver,
// each stretch of a path was planned. Internal to the verifier.
#pragma once

#include <optional>

#include "common/model/plan.h"
#include "common/model/scene.h"
#include "common/planning/verifier.h"

namespace accord::verification {

// The first thing wrong with the segments of a robot that has any: they run from 0 to its last
// waypoint, in order, without gaps or overlaps; each names robots of the scene, none twice, itself
// among them. Plans of other planners have none, which is fine.
// Requires: check_form() found nothing.
std::optional<Violation> check_segments(const Scene& scene, const Plan& plan);

}  // namespace accord::verification
