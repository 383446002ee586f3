// When two subproblems are one and the same: to the bit, so that what solves one solves the other,
// with the same paths to the bit. (Equal is not enough: 0 equals -0.)
// Thread safe.
#pragma once

#include "common/planning/subproblem.h"

namespace accord {

bool are_identical(const Subproblem& a, const Subproblem& b);

}  // namespace accord
