// accord doctor: why processes see each other and no data flows.
#include <algorithm>
#include <iostream>
#include <memory>

#include "client/commands.h"
#include "client/doctor/diagnosis.h"
#include "client/doctor/observe.h"
#include "client/doctor/report.h"
#include "client/interrupt.h"
#include "client/service_commands.h"
#include "client/service_port.h"

namespace accord {
namespace {

constexpr double kPatience = 6;  // s

struct CommandOptions {
  // As a coordinator or a worker with these settings would have it.
  ServiceOptions service{DdsOptions().segment_bytes};
  Patience patience{kPatience};
  bool json = false;
};

ExitCode exit_code_of(const std::vector<Finding>& findings, const Observations& seen) {
  const bool has_fault = std::ranges::any_of(
      findings, [](const Finding& finding) { return finding.severity == Severity::kFault; });
  if (has_fault) return ExitCode::kFault;
  return seen.as_told.survey.service ? ExitCode::kSuccess : ExitCode::kNoService;
}

ExitCode run(CommandOptions& options) {
  // Its shared memory goes with it, however it ends.
  const CancelOnSignal on_signal;
  const Observations seen = observe(options.service.resolve(), ACCORD_VERSION,
                                    options.patience.duration(), on_signal.cancelled());
  if (on_signal.cancelled()) return ExitCode::kTimeout;
  const auto findings = diagnose(seen);
  options.json ? write_json(findings, std::cout) : write_text(findings, std::cout);
  return exit_code_of(findings, seen);
}

}  // namespace

void add_doctor_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<CommandOptions>();
  CLI::App* command = app.add_subcommand(kDoctorCommand.name, kDoctorCommand.description);
  command->add_flag("--json", options->json, "An object of JSON a line instead of text");
  options->patience.add_to(*command, "Seconds to listen, where something that is missing may come");
  options->service.add_to(*command);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
