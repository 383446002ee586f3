// What a resolution must look like to answer its subproblem, whatever its paths run into.
#pragma once

#include <optional>
#include <string>

#include "common/model/scene.h"
#include "common/planning/subproblem.h"

namespace accord {

// nullopt where the resolution is solved, or improves a crowd's paths, and
//   * holds a path a task, from the task's start at the window's start to its goal (up to whole
//     turns), with finite times that increase;
//   * ends when the last path does;
//   * leaves robots only as Resolution::left allows, and those of a crowd on their present paths.
// Else a sentence that names the robot and what is wrong.
// Requires: the subproblem is of the scene. Any resolution is acceptable input. Thread safe.
std::optional<std::string> form_fault(const Scene& scene, const Subproblem& subproblem,
                                      const Resolution& resolution);

}  // namespace accord
