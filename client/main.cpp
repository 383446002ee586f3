// The `accord` command.
#include "client/application.h"
#include "client/commands.h"
#include "client/delegation.h"
#include "client/service_commands.h"

int main(int argc, char** argv) {
  using namespace accord;
  return run_application(argc, argv, [argv](CLI::App& app, ExitCode& exit_code) {
    add_plan_command(app, exit_code);
    for (const ServiceCommand& command : {kSubmitCommand, kWatchCommand, kCancelCommand,
                                          kWorkersCommand, kHealthCommand, kDoctorCommand}) {
      add_delegated_command(app, exit_code, command, argv);
    }
    add_verify_command(app, exit_code);
    add_info_command(app, exit_code);
    add_render_command(app, exit_code);
    add_replay_command(app, exit_code);
  });
}
