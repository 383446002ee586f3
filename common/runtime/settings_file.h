// A configuration file, read against a table of settings:
//
//     threads: 8
//     dds:
//       domain: 3
//       interfaces: [127.0.0.1]
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/runtime/settings.h"

namespace accord {

// What a file says of one setting.
struct FileEntry {
  const Setting* setting;           // of the table
  std::vector<std::string> values;  // accepted; one, unless it is a list
  Place place;
};

// The settings that the file gives, in the table's order; what is wrong is reported: a key that is
// unknown or repeated, a value of a wrong type or that its setting does not accept, a file that
// cannot be read. An empty file gives none. Thread safe.
std::vector<FileEntry> read_settings_file(const Settings& settings,
                                          const std::filesystem::path& file, Faults& faults);

}  // namespace accord
