// The names that requests choose from: methods of planning, and solvers of subproblems.
#pragma once

#include <string>
#include <vector>

namespace accord {

// ARC, and the baselines, which put the whole problem to the one solver of their name.
inline constexpr const char* kArcMethod = "arc";
const std::vector<std::string>& method_names();

// Those that ARC's hierarchy may name, least coupling first.
const std::vector<std::string>& local_solver_names();
// Those of the hierarchy unless told otherwise: "lockstep-query" for crowds too large for the
// levels, and the paper's levels, "prioritized-query", "decoupled-prm" and "composite-prm".
const std::vector<std::string>& default_solver_names();

// All that a resolution may name as its solver: levels, baselines, and how a robot alone is given
// its path ("straight", or "prm").
const std::vector<std::string>& resolution_solver_names();
// The name under which such a solver is counted: "other" for whatever is none of them, since a
// worker may say anything.
std::string counted_solver(const std::string& name);
inline constexpr const char* kOtherSolver = "other";

}  // namespace accord
