// accord plan: from a scene to a proven plan.
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "client/commands.h"
#include "client/engine/planner.h"
#include "client/files.h"
#include "client/interrupt.h"
#include "client/option_values.h"
#include "client/plan_output.h"
#include "client/progress_line.h"
#include "common/runtime/cores.h"
#include "common/runtime/log.h"

namespace accord {
namespace {

struct CommandOptions {
  PlanQuestion question;
  unsigned threads = 1;
  LogLevel log = LogLevel::kWarning;
};

Plan plan_with_progress(const std::shared_ptr<const Scene>& scene, const CommandOptions& options) {
  const PlanQuestion& question = options.question;
  PlanOptions request;
  request.method = question.method;
  request.seed = question.seed;
  request.solvers = question.solvers;
  request.threads = options.threads;
  if (question.timeout > 0) request.timeout = question.timeout;
  ProgressLine line(std::cerr, scene->robots.size());
  ProgressCallback report;
  if (!question.quiet && stderr_is_a_terminal()) {
    report = [&line](const Progress& progress) { line.show(progress); };
  }
  const CancelOnSignal on_signal;
  return plan(scene, request, report, &on_signal.cancelled());
}

ExitCode run(const CommandOptions& options) {
  refuse_overwriting(options.question.output, {options.question.scene});
  start_log("accord", {options.log, LogFormat::kText});
  const std::shared_ptr<const Scene> scene = load_scene_or_explain(options.question.scene);
  if (!scene) return ExitCode::kBadInput;
  const Plan plan = plan_with_progress(scene, options);
  // A signal during the last steps, the proof say, which do not look at the flag.
  if (cancelled_by_signal() && exit_code_of(plan.status) != ExitCode::kTimeout) {
    std::cerr << "cancelled: before the plan was written\n";
    return ExitCode::kTimeout;
  }
  return hand_out(scene, plan, options.question, options.threads);
}

void add_options(CLI::App& command, CommandOptions& options) {
  add_plan_question(command, options.question);
  command
      .add_option("-w,--workers", options.threads,
                  "Threads; the plan is the same for any number (default: one for each core)")
      ->transform(plain_integer())
      ->check(CLI::Range(1U, 1024U));
  const std::map<std::string, LogLevel> levels(kLogLevels.begin(), kLogLevels.end());
  command
      .add_option("--log", options.log,
                  "Least level of what is logged to stderr; debug: a line for each subproblem, and "
                  "for each solver that is tried on it")
      ->transform(CLI::CheckedTransformer(levels));
}

}  // namespace

void add_plan_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<CommandOptions>();
  options->threads = cores();
  CLI::App* command = app.add_subcommand(
      "plan", "Plan a scene: every robot from its start to its goal, proved free of collisions");
  add_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
