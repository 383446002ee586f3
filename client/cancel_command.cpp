// accord cancel: ends requests of a service, whoever has submitted them.
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "client/commands.h"
#include "client/fleet/cancellation.h"
#include "client/service_commands.h"
#include "client/service_port.h"
#include "client/terminal_text.h"
#include "common/io/request_names.h"
#include "common/transport/fleet/fleet_limits.h"

namespace accord {
namespace {

struct CommandOptions {
  std::vector<std::string> ids;
  ServiceOptions service;
  Patience patience;
};

ExitCode tell(const std::string& id, const Plan& plan) {
  std::cout << id << ": ";
  if (plan.status == PlanStatus::kCancelled) {
    std::cout << "cancelled\n";
  } else {
    std::cout << "had ended before: " << to_string(plan.status) << "\n";
  }
  std::cout << std::flush;  // others may take long
  return ExitCode::kSuccess;
}

ExitCode tell(const std::string& id, const NoAnswer& none) {
  if (none.why == NoAnswer::Why::kNoService) {
    std::cerr << "accord: " << id << ": not known whether it is cancelled\n";
    return ExitCode::kNoService;
  }
  std::cerr << "accord: " << id << ": " << to_string(none.reply.reason) << ": "
            << terminal_text(none.reply.text, kFleetTextBytes) << "\n";
  return ExitCode::kBadInput;
}

ExitCode run(CommandOptions& options) {
  const auto port = open_port_or_explain(options.service.resolve(), HeardPlans::kOutcomes);
  if (!port) return ExitCode::kNoService;
  FleetManager::Settings settings;
  settings.patience = options.patience.duration();
  Cancellation cancellation(*port, options.ids, settings);
  ExitCode worst = ExitCode::kSuccess;
  while (cancellation.is_waiting()) {
    const auto end = cancellation.next(std::chrono::seconds(1));
    if (!end) continue;
    worst = std::max(worst,
                     std::visit([&end](const auto& how) { return tell(end->id, how); }, end->how));
  }
  if (worst == ExitCode::kNoService) explain_no_service(options.patience);
  return worst;
}

}  // namespace

void add_cancel_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<CommandOptions>();
  CLI::App* command = app.add_subcommand(kCancelCommand.name, kCancelCommand.description);
  command->add_option("ID", options->ids, "The requests' ids")
      ->required()
      ->type_name("")
      ->check([](const std::string& text) {
        return is_request_id(text) ? "" : "expected " + std::string(kRequestIdInWords);
      });
  options->patience.add_to(*command, "Seconds for which a service may say nothing");
  options->service.add_to(*command);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
