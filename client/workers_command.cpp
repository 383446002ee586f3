// accord workers: who works for a service.
#include <iostream>
#include <memory>

#include "client/commands.h"
#include "client/service_commands.h"
#include "client/service_port.h"
#include "client/watch/columns.h"
#include "client/watch/first_picture.h"
#include "client/watch/live_screen.h"
#include "client/watch/screen.h"

namespace accord {
namespace {

struct CommandOptions {
  ServiceOptions service;
  Patience patience;
  bool json = false;
};

ExitCode run(CommandOptions& options) {
  const auto port = open_port_or_explain(options.service.resolve(), HeardPlans::kOutcomes);
  if (!port) return ExitCode::kNoService;
  WatchedFleet fleet;
  const std::atomic<bool> never{false};
  if (!listen_for_first_picture(*port, fleet, options.patience.duration(), never)) {
    explain_no_service(options.patience);
    return ExitCode::kNoService;
  }
  const std::vector<Row> rows = rows_of_workers(fleet);
  if (options.json) {
    for (const Row& row : rows) std::cout << json_of("worker", row) << "\n";
    return ExitCode::kSuccess;
  }
  for (const std::string& line : in_columns(rows, stdout_size().width)) std::cout << line << "\n";
  if (rows.empty()) {
    std::cout << "no workers; start accord-worker in the same domain and cluster\n";
  }
  return ExitCode::kSuccess;
}

}  // namespace

void add_workers_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<CommandOptions>();
  CLI::App* command = app.add_subcommand(kWorkersCommand.name, kWorkersCommand.description);
  command->add_flag("--json", options->json, "An object of JSON a line instead of a table");
  options->patience.add_to(*command, "Seconds until a service has to have answered");
  options->service.add_to(*command);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
