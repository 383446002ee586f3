// What `accord plan` says about its outcome.
#pragma once

#include <string>

#include "common/model/plan.h"
#include "common/model/scene.h"
#include "common/planning/verifier.h"

namespace accord {

// A block of aligned lines. Requires: the plan is solved, the verdict its proof.
std::string solved_text(const Scene& scene, const Plan& plan, const Verdict& verdict);

// One line: the status and why.
std::string unsolved_text(const Plan& plan);

}  // namespace accord
