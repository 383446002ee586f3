// The command line of a service: every setting of its table as a flag, --config, --help and
// --version. The one place that binds settings to CLI11.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/runtime/process_exit.h"
#include "common/runtime/settings.h"

namespace accord {

struct Program {
  std::string name;     // "accord-worker"
  std::string purpose;  // a sentence
  std::string version;
};

// What reading a command line came to.
struct Start {
  std::optional<ProcessExit> end;     // nullopt: go on; else end with this, having printed
  std::string output;                 // for stdout: what --help or --version asked for
  std::string errors;                 // for stderr: all that is wrong, a line each
  std::vector<std::string> warnings;  // to be logged, once there is a log
};

// Sets the variables that the table is bound to from flags, `environment` and the file that
// --config or ACCORD_CONFIG names. Touches nothing but that file; for the environment of this
// process see process_environment(). Requires: argv[0] to argv[argc - 1] as main() has them.
Start read_command_line(const Program& program, const Settings& settings, int argc,
                        const char* const* argv,
                        const std::map<std::string, std::string>& environment);

// The same with this process's environment, and prints what is to be printed.
Start start_up(const Program& program, const Settings& settings, int argc, const char* const* argv);

}  // namespace accord
