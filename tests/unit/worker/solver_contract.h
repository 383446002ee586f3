// What every Solver promises, as checks that any of them (and a wrong one) can be held to.
#pragma once

#include <atomic>
#include <string>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"
#include "worker/solver.h"

namespace accord::testing {

// Empty when the resolution keeps the contract of Solver::solve for this subproblem; else what it
// breaks. Unsolved resolutions always keep it.
std::string contract_breach(const CollisionWorld& world, const Subproblem& subproblem,
                            const Resolution& resolution);

}  // namespace accord::testing
