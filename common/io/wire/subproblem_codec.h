// Subproblems, and the solvers to try on them, to bytes and back.
//
// Canonical: one value, one sequence of bytes. Thread safe. Nothing throws but std::bad_alloc.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "common/io/wire/bytes.h"
#include "common/model/scene.h"
#include "common/planning/subproblem.h"

namespace accord {

Bytes encode_subproblem(const Subproblem& subproblem);

// The subproblem, bit for bit, or a sentence that says which field is wrong and what was expected.
// Takes any bytes: a subproblem that comes back is one that every solver can be given: its robots
// are the scene's, each once and in order; numbers are finite (but for times that may be infinite)
// and as many as the robot has degrees of freedom; times increase; regions are boxes inside the
// robot's space; limits lie within those of SolverLimits::unlimited(). Whether its paths are free
// is for the solvers to find out.
tl::expected<Subproblem, std::string> decode_subproblem(BytesView bytes, const Scene& scene);

// What the tasks of one batch have in common beside their scene.
struct Hierarchy {
  std::vector<std::string> solvers;  // names, in order; whether they exist is for make_solver()
  std::string request;               // whose tasks they are, for logs; empty: not told
};

// Requires: as decode_hierarchy() asks for.
Bytes encode_hierarchy(const std::vector<std::string>& solvers, const std::string& request = "");
tl::expected<Hierarchy, std::string> decode_hierarchy(BytesView bytes);

}  // namespace accord
