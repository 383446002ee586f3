// Commands that another program carries out.
#pragma once

#include <CLI/CLI.hpp>

#include "client/exit_code.h"
#include "client/service_commands.h"

namespace accord {

// The command becomes accord-fleet, from the folder of this program, with the whole command line;
// where that cannot be started, it says why. Requires: `argv` is main()'s, and outlives `app`.
void add_delegated_command(CLI::App& app, ExitCode& exit_code, const ServiceCommand& command,
                           char** argv);

}  // namespace accord
