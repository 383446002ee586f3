// The levels of the solver hierarchy that a subproblem goes through: what can be known of them
// without solving anything, so that coordinator and worker agree on it.
// Thread safe.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/planning/subproblem.h"

namespace accord {

// One robot that has nobody to look out for is given its path without any of the levels.
bool is_robot_alone(const Subproblem& subproblem);

// Whether a solver is meant for such subproblems. Of others it gives up at once, with no effort.
bool is_meant_for(std::string_view solver, const Subproblem& subproblem);

// Those of the solvers that are meant for it, in order.
std::vector<std::string> levels_of(const Subproblem& subproblem,
                                   const std::vector<std::string>& solvers);

}  // namespace accord
