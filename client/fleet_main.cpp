// accord-fleet: those commands of `accord` that ask a service.
#include "client/application.h"
#include "client/commands.h"

int main(int argc, char** argv) {
  using namespace accord;
  return run_application(argc, argv, [](CLI::App& app, ExitCode& exit_code) {
    add_submit_command(app, exit_code);
    add_watch_command(app, exit_code);
    add_cancel_command(app, exit_code);
    add_workers_command(app, exit_code);
    add_health_command(app, exit_code);
    add_doctor_command(app, exit_code);
  });
}
