// accord plan: from a scene to a proven plan.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "client/commands.h"
#include "client/engine/planner.h"
#include "client/files.h"
#include "client/interrupt.h"
#include "client/option_values.h"
#include "client/plan_text.h"
#include "client/progress_line.h"
#include "common/io/plan_file.h"
#include "common/planning/verifier.h"

namespace accord {
namespace {

struct CommandOptions {
  std::string scene;
  std::string output;
  PlanOptions plan;
  double timeout = 0;  // s; 0: none
  bool json = false;
  bool quiet = false;
  spdlog::level::level_enum log = spdlog::level::warn;
};

ExitCode exit_code_of(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return ExitCode::kSuccess;
    case PlanStatus::kInfeasible:
      return ExitCode::kInfeasible;
    case PlanStatus::kTimeout:
    case PlanStatus::kCancelled:
      return ExitCode::kTimeout;
    case PlanStatus::kInvalid:
      return ExitCode::kBadInput;
  }
  return ExitCode::kBug;
}

Plan plan_with_progress(const std::shared_ptr<const Scene>& scene, const CommandOptions& options) {
  PlanOptions request = options.plan;
  if (options.timeout > 0) request.timeout = options.timeout;
  ProgressLine line(std::cerr, scene->robots.size());
  ProgressCallback report;
  if (!options.quiet && stderr_is_a_terminal()) {
    report = [&line](const Progress& progress) { line.show(progress); };
  }
  const CancelOnSignal on_signal;
  return plan(scene, request, report, &on_signal.cancelled());
}

void log_to_stderr(spdlog::level::level_enum least) {
  const auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
  auto logger = std::make_shared<spdlog::logger>("accord", sink);
  logger->set_level(least);
  spdlog::set_default_logger(std::move(logger));
}

ExitCode hand_out(const std::shared_ptr<const Scene>& scene, const Plan& plan,
                  const CommandOptions& options) {
  const std::string json = to_json(plan);
  const bool print_plan = options.json || options.output == kStandardOutput;
  const bool write_file = !options.output.empty() && options.output != kStandardOutput;
  if (write_file && !write_file_or_explain(options.output, json)) return ExitCode::kBadInput;
  const bool solved = plan.status == PlanStatus::kSolved;
  if (print_plan) {
    std::cout << json;
  } else if (solved && !options.quiet) {
    std::cout << solved_text(*scene, plan, verify(scene, plan, options.plan.workers));
  }
  if (!solved) std::cerr << unsolved_text(plan);
  return exit_code_of(plan.status);
}

ExitCode run(const CommandOptions& options) {
  refuse_overwriting(options.output, {options.scene});
  log_to_stderr(options.log);
  const std::shared_ptr<const Scene> scene = load_scene_or_explain(options.scene);
  if (!scene) return ExitCode::kBadInput;
  const Plan plan = plan_with_progress(scene, options);
  // A signal during the last steps, the proof say, which do not look at the flag.
  if (cancelled_by_signal() && exit_code_of(plan.status) != ExitCode::kTimeout) {
    std::cerr << "cancelled: before the plan was written\n";
    return ExitCode::kTimeout;
  }
  return hand_out(scene, plan, options);
}

void add_options(CLI::App& command, CommandOptions& options) {
  command.add_option("SCENE", options.scene, "Scene file (.yaml)")->required();
  command
      .add_option("-o,--output", options.output,
                  "Plan file to write (.json); -: print it, as --json does")
      ->check(output_name());
  command.add_option("-s,--seed", options.plan.seed, "Decides all that is drawn at random")
      ->capture_default_str()
      ->transform(plain_integer());
  command.add_option("-t,--timeout", options.timeout, "Give up after so many seconds")
      ->check(seconds(1e-3, 1e7));
  command
      .add_option("-w,--workers", options.plan.workers,
                  "Threads; the plan is the same for any number (default: one for each core)")
      ->transform(plain_integer())
      ->check(CLI::Range(1U, 1024U));
  command
      .add_option("-m,--method", options.plan.method,
                  "arc, or a baseline that puts the whole problem to one solver")
      ->capture_default_str()
      ->check(CLI::IsMember(method_names()));
  command
      .add_option_function<std::string>(
          "--solvers",
          [&options](const std::string& list) {
            options.plan.solvers = solvers_in(list, solver_names());
          },
          fmt::format("ARC's solvers for conflicts, tried in this order, of {} (default: {})",
                      fmt::join(solver_names(), ","), fmt::join(default_solvers(), ",")))
      ->type_name("NAME,...");
  command.add_flag("--json", options.json, "Print the plan instead of a summary");
  command.add_flag("-q,--quiet", options.quiet, "Print neither progress nor summary");
  const std::map<std::string, spdlog::level::level_enum> levels{{"debug", spdlog::level::debug},
                                                                {"info", spdlog::level::info},
                                                                {"warning", spdlog::level::warn},
                                                                {"error", spdlog::level::err},
                                                                {"off", spdlog::level::off}};
  command
      .add_option("--log", options.log,
                  "Least level of what is logged to stderr; info: what it cost; debug: a line for "
                  "each subproblem")
      ->transform(CLI::CheckedTransformer(levels));
}

}  // namespace

void add_plan_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<CommandOptions>();
  options->plan.workers = std::max(1U, std::thread::hardware_concurrency());
  CLI::App* command = app.add_subcommand(
      "plan", "Plan a scene: every robot from its start to its goal, proved free of collisions");
  add_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
