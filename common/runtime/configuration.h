// From what a person wrote, in a file, in environment variables and in flags, to the variables that
// a table of settings is bound to. A flag counts more than a variable, a variable more than the
// file, the file more than the default. All that is wrong is found at once: what nobody would use
// because something else counts more, too.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/runtime/settings.h"

namespace accord {

// What was written, and where.
struct Written {
  std::optional<std::filesystem::path> file;
  std::map<std::string, std::string> variables;           // the environment; empty ones count as
                                                          // not there
  std::map<std::string, std::vector<std::string>> flags;  // by "--domain", as often as given
};

// What is wrong with it: a line each, which names the file and line, the variable or the flag.
struct WrittenFaults {
  std::vector<std::string> usage;     // of flags and variables
  std::vector<std::string> file;      // of the file, or what it lacks
  std::vector<std::string> warnings;  // variables ACCORD_... that are no setting of the table: they
                                      // may be another process's

  bool none() const { return usage.empty() && file.empty(); }
};

// Sets the variables that the table is bound to. Where there are faults, some of them may be set.
// Throws nothing but std::bad_alloc.
WrittenFaults configure(const Settings& settings, const Written& written);

// The environment of this process. Requires: no other thread changes it.
std::map<std::string, std::string> process_environment();

}  // namespace accord
