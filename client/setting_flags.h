// A table of settings as flags of a command, and the environment variables that stand for them:
// those that services have, too (docs/operations.md), but from no file.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "common/runtime/settings.h"

namespace accord {

class SettingFlags {
 public:
  SettingFlags() = default;
  SettingFlags(const SettingFlags&) = delete;
  SettingFlags& operator=(const SettingFlags&) = delete;

  // Flags in a group of --help. Must outlive the command.
  void add_to(CLI::App& command, const Settings& table, const std::string& group);
  // Sets the variables that the table is bound to, once the command line is read. Throws
  // CLI::ValidationError. Requires: the table that was added.
  void resolve(const Settings& table);

 private:
  std::map<std::string, std::vector<std::string>> flags_;
};

}  // namespace accord
