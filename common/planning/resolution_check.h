// Proves what a resolution promises, whoever made it: so that a worker whose paths do not hold, for
// a fault of its memory or its build say, is found out before they are committed.
//
// Stands on the same certificates as planning (no samples): CollisionWorld's motion queries and
// contacts of paths. Costs a small share of what solving did.
//
// What only solving again could tell is not found: that a subproblem said to be exhausted is not,
// that another resolution which holds is not the one that its solvers make, and what it is said to
// have cost.
#pragma once

#include <optional>
#include <string>

#include "common/geometry/collision_world.h"
#include "common/planning/subproblem.h"

namespace accord {

// nullopt where the resolution keeps the contract of Solver::solve, or claims nothing, not being
// solved; else a sentence that names the robots and what is wrong. Of what is claimed is proved:
//   * its form (form_fault());
//   * each path, that its robot can move that fast, and is free of obstacles, bounds and itself
//     within its limits. Paths that are the present ones are taken to be;
//   * of each two robots of the team, and each of it and each outsider, that they are clear of each
//     other until one of the two leaves the window: when it arrives where it goes on after its
//     goal, else at the horizon; an outsider at its `until`; all at the crowd's `clear_until`;
//   * of a crowd that is not solved the same, but of those that are left nothing;
//   * of a crowd in lockstep the same, but no outsiders, and of those that are left only until the
//     last of the others has arrived.
// Any resolution is acceptable input. Pure; thread safe.
// Requires: the subproblem is of the world's scene. The world's margin is kDetectionMargin: what
// planning proves with its own margin is never refused for rounding, and what is not refused holds
// at the scene's clearance.
std::optional<std::string> resolution_fault(const CollisionWorld& world,
                                            const Subproblem& subproblem,
                                            const Resolution& resolution);

}  // namespace accord
