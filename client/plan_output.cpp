#include "client/plan_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

#include "client/files.h"
#include "client/option_values.h"
#include "client/plan_text.h"
#include "common/io/plan_file.h"
#include "common/planning/method_names.h"
#include "common/planning/verifier.h"

namespace accord {

void add_plan_question(CLI::App& command, PlanQuestion& question) {
  command.add_option("SCENE", question.scene, "Scene file (.yaml)")->required();
  command
      .add_option("-o,--output", question.output,
                  "Plan file to write (.json); -: print it, as --json does")
      ->check(output_name());
  command.add_option("-s,--seed", question.seed, "Decides all that is drawn at random")
      ->capture_default_str()
      ->transform(plain_integer());
  command.add_option("-t,--timeout", question.timeout, "Give up after so many seconds")
      ->check(seconds_within(1e-3, 1e7));
  command
      .add_option("-m,--method", question.method,
                  "arc, or a baseline that puts the whole problem to one solver")
      ->capture_default_str()
      ->check(CLI::IsMember(method_names()));
  command
      .add_option_function<std::string>(
          "--solvers",
          [&question](const std::string& list) {
            question.solvers = solvers_in(list, local_solver_names());
          },
          fmt::format("ARC's solvers for conflicts, tried in this order, of {} (default: {})",
                      fmt::join(local_solver_names(), ","), fmt::join(default_solver_names(), ",")))
      ->type_name("NAME,...");
  command.add_flag("--json", question.json, "Print the plan instead of a summary");
  command.add_flag("-q,--quiet", question.quiet, "Print neither progress nor summary");
}

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

ExitCode hand_out(const std::shared_ptr<const Scene>& scene, const Plan& plan,
                  const PlanQuestion& question, unsigned threads) {
  const std::string json = to_json(plan);
  const bool print_plan = question.json || question.output == kStandardOutput;
  const bool write_file = !question.output.empty() && question.output != kStandardOutput;
  if (write_file && !write_file_or_explain(question.output, json)) return ExitCode::kBadInput;
  const bool solved = plan.status == PlanStatus::kSolved;
  if (print_plan) {
    std::cout << json;
  } else if (solved && !question.quiet) {
    std::cout << solved_text(*scene, plan, verify(scene, plan, threads));
  }
  if (!solved) std::cerr << unsolved_text(plan);
  return exit_code_of(plan.status);
}

}  // namespace accord
