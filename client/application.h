// What the programs behind `accord` have in common: one command line, one way to say what is wrong,
// one table of exit codes.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "client/exit_code.h"

namespace accord {

// Parses the command line and runs the command that it names, of those that `add_commands` adds.
// What to exit with. Call once, from main().
int run_application(int argc, char** argv,
                    const std::function<void(CLI::App&, ExitCode&)>& add_commands);

}  // namespace accord
