// The subcommands of `accord`, each in a source file of its own. Each function adds one to the
// application; when the command line names it, it runs and sets `exit_code`.
#pragma once

#include <CLI/CLI.hpp>

#include "client/exit_code.h"

namespace accord {

void add_plan_command(CLI::App& app, ExitCode& exit_code);
void add_submit_command(CLI::App& app, ExitCode& exit_code);
void add_watch_command(CLI::App& app, ExitCode& exit_code);
void add_cancel_command(CLI::App& app, ExitCode& exit_code);
void add_workers_command(CLI::App& app, ExitCode& exit_code);
void add_health_command(CLI::App& app, ExitCode& exit_code);
void add_doctor_command(CLI::App& app, ExitCode& exit_code);
void add_verify_command(CLI::App& app, ExitCode& exit_code);
void add_info_command(CLI::App& app, ExitCode& exit_code);
void add_render_command(CLI::App& app, ExitCode& exit_code);
void add_replay_command(CLI::App& app, ExitCode& exit_code);

}  // namespace accord
