// Reads and writes the files that commands name, and explains to the person at the terminal (on
// standard error) why one cannot be.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/model/plan.h"
#include "common/model/scene.h"

namespace accord {

// nullptr: explained.
std::shared_ptr<const Scene> load_scene_or_explain(const std::string& path);

// nullopt: explained.
std::optional<Plan> load_plan_or_explain(const std::string& path);

// Replaces the file as a whole or not at all. False: explained.
bool write_file_or_explain(const std::string& path, std::string_view text);

}  // namespace accord
