// accord verify: proves or refutes a plan from any source.
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <string>

#include "client/commands.h"
#include "client/counted.h"
#include "client/files.h"
#include "client/plan_match.h"
#include "client/table.h"
#include "client/verdict_text.h"
#include "common/planning/verifier.h"
#include "common/runtime/cores.h"

namespace accord {
namespace {

struct VerifyOptions {
  std::string scene;
  std::string plan;
  bool quiet = false;
};

ExitCode run(const VerifyOptions& options) {
  const std::shared_ptr<const Scene> scene = load_scene_or_explain(options.scene);
  if (!scene) return ExitCode::kBadInput;
  const std::optional<Plan> plan = load_plan_or_explain(options.plan);
  if (!plan) return ExitCode::kBadInput;
  if (const auto other = other_scene(*scene, *plan); other && !options.quiet) {
    std::cerr << fmt::format("{}: note: {}\n", options.plan, *other);
  }

  const unsigned threads = cores();
  const Verdict verdict =
      verify(scene, *plan, threads, options.quiet ? Beyond::kNothing : Beyond::kSeparations);
  if (!verdict.proved()) {
    std::cout << "refuted: " << verdict.violation->text << '\n';
    return ExitCode::kInfeasible;
  }
  if (options.quiet) return ExitCode::kSuccess;
  Table table;
  table.add("proved", fmt::format("{} free of collisions at every instant",
                                  scene->robots.size() == 1
                                      ? "1 robot is"
                                      : counted(scene->robots.size(), "robot") + " are"));
  table.add("makespan", fmt::format("{:.2f} s", plan->makespan));
  add_separations(table, *scene, verdict);
  std::cout << table.str();
  return ExitCode::kSuccess;
}

}  // namespace

void add_verify_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand(
      "verify", "Prove that a plan, from whatever planner, is free of collisions at every instant");
  command->add_option("SCENE", options->scene, "Scene file (.yaml)")->required();
  command->add_option("PLAN", options->plan, "Plan file (.json)")->required();
  command->add_flag("-q,--quiet", options->quiet, "Print nothing for a plan that is proved");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
