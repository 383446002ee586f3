// What has to hold of a plan's numbers before its motions can be looked at, and of the costs that
// it claims. Internal to the verifier.
#pragma once

#include <optional>
#include <vector>

#include "common/model/plan.h"
#include "common/model/scene.h"
#include "common/planning/verifier.h"

namespace accord::verification {

// The first thing wrong with the plan's form: its status, robots that are missing, unknown or
// there twice, paths without waypoints, of a wrong dimension, with times that do not start at 0 or
// do not increase, or with numbers that are not finite.
std::optional<Violation> check_form(const Scene& scene, const Plan& plan);

// The plan's paths in the scene's order. Requires: check_form() found nothing.
std::vector<const Trajectory*> paths_in_order(const Scene& scene, const Plan& plan);

// Whether makespan and sums of costs are those of the paths.
// Requires: check_form() found nothing.
std::optional<Violation> check_costs(const Scene& scene, const Plan& plan);

}  // namespace accord::verification
