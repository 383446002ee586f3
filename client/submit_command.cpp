// accord submit: from a scene to a proven plan, by a service.
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <iostream>
#include <memory>
#include <random>
#include <string>

#include "client/commands.h"
#include "client/files.h"
#include "client/fleet/fleet_manager.h"
#include "client/fleet/request_file.h"
#include "client/interrupt.h"
#include "client/option_values.h"
#include "client/plan_output.h"
#include "client/progress_line.h"
#include "client/service_commands.h"
#include "client/service_options.h"
#include "client/service_port.h"
#include "common/io/request_names.h"
#include "common/io/words.h"
#include "common/runtime/cores.h"
#include "common/transport/fleet/fleet_limits.h"

namespace accord {
namespace {

struct CommandOptions {
  PlanQuestion question;
  ServiceOptions service;
  std::string id;  // empty: one of its own
  std::int32_t priority = 0;
  Patience patience;
};

// No other request's, for all that chance can do.
std::string fresh_id() {
  std::random_device entropy;
  std::string id = "request-";
  constexpr const char* kDigits = "0123456789abcdef";
  for (int i = 0; i < 16; ++i) id += kDigits[entropy() % 16];
  return id;
}

// A line for each phase; on a terminal, one line for all.
class Reporter {
 public:
  Reporter(bool quiet, std::size_t robots) : quiet_(quiet) {
    if (!quiet && stderr_is_a_terminal()) {
      line_ = std::make_unique<ProgressLine>(std::cerr, robots);
    }
  }
  void show(const RequestState& state) {
    if (line_) {
      line_->show(state);
    } else if (!quiet_ && phase_ != state.phase) {
      std::cerr << in_words(state) << "\n";
    }
    phase_ = state.phase;
  }

 private:
  bool quiet_;
  std::unique_ptr<ProgressLine> line_;
  std::optional<RequestPhase> phase_;
};

std::string in_words(const RequestReply& reply) {
  std::string out = "rejected: " + std::string(to_string(reply.reason)) + ": ";
  if (!reply.field.empty()) out += printable(reply.field, kFleetTextBytes) + ": ";
  return out + printable(reply.text, kFleetTextBytes);
}

ExitCode explain(const NoAnswer& none, const CommandOptions& options) {
  if (none.why == NoAnswer::Why::kNoService) {
    explain_no_service(options.patience);
    return ExitCode::kNoService;
  }
  const RequestReply& reply = none.reply;
  std::cerr << in_words(reply) << "\n";
  return ExitCode::kBadInput;
}

PlanRequest request_of(PlanRequest request, const CommandOptions& options) {
  const PlanQuestion& question = options.question;
  request.id = options.id.empty() ? fresh_id() : options.id;
  request.method = question.method;
  request.seed = question.seed;
  request.solvers = question.solvers;
  request.deadline = question.timeout;
  request.priority = options.priority;
  return request;
}

ExitCode run(CommandOptions& options) {
  const DdsOptions& dds = options.service.resolve();
  refuse_overwriting(options.question.output, {options.question.scene});
  RequestFile read = request_for_scene(options.question.scene);
  if (!read.scene) {
    for (const Diagnostic& fault : read.faults) std::cerr << to_string(fault) << "\n";
    return ExitCode::kBadInput;
  }
  const auto port = open_port_or_explain(dds, HeardPlans::kWhole);
  if (!port) return ExitCode::kNoService;
  FleetManager::Settings settings;
  settings.patience = options.patience.duration();
  FleetManager manager(*port, settings);
  const CancelOnSignal on_signal;
  tl::expected<Plan, NoAnswer> answer;
  {
    Reporter reporter(options.question.quiet, read.scene->robots.size());
    answer = manager.plan(
        request_of(std::move(read.request), options),
        [&reporter](const RequestState& state) { reporter.show(state); }, on_signal.cancelled());
  }
  if (!answer) return explain(answer.error(), options);
  const unsigned threads = cores();
  return hand_out(read.scene, *answer, options.question, threads);
}

}  // namespace

void add_submit_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<CommandOptions>();
  CLI::App* command = app.add_subcommand(kSubmitCommand.name, kSubmitCommand.description);
  add_plan_question(*command, options->question);
  command
      ->add_option("--id", options->id,
                   "The request's id; the same request twice is one request (default: a new one)")
      ->check([](const std::string& text) {
        return is_request_id(text) ? "" : "expected " + std::string(kRequestIdInWords);
      });
  command->add_option("--priority", options->priority, "The higher, the sooner it is begun")
      ->capture_default_str();
  options->patience.add_to(*command, "Seconds until a service has to have accepted the request");
  options->service.add_to(*command);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
