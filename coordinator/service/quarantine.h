// Tasks that nobody could solve, each kept in a file that `accord replay` takes.
// Thread safe.
#pragma once

#include <filesystem>
#include <string>

#include "coordinator/dispatch/remote_crew.h"

namespace accord {

// Writes the task that a request failed of to a file of the folder, which is made where it is
// missing. What to tell of it, behind what the failure says itself: where it is, or why it is
// nowhere. Nothing where the folder is empty: then none are kept. Requires: the id is a request's.
std::string keep_task(const std::filesystem::path& folder, const std::string& request,
                      const TaskFailure& failure);

}  // namespace accord
