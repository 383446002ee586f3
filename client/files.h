// Reads and writes the files that commands name, and standard output, and explains to the person at
// the terminal (on standard error) why one cannot be.
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

// What stands for standard output where the file to write is named.
inline constexpr std::string_view kStandardOutput = "-";

// Replaces the file as a whole or not at all; kStandardOutput is only written to, and whether that
// went well is for flush_output_or_explain() to say. False: explained.
bool write_file_or_explain(const std::string& path, std::string_view text);

// Whether all that was printed on standard output has reached it. False: explained. Call once, last
// of all.
bool flush_output_or_explain();

}  // namespace accord
