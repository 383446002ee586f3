// accord render: a picture of a scene and its plan.
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "client/commands.h"
#include "client/files.h"
#include "client/option_values.h"
#include "client/plan_match.h"
#include "client/render/picture.h"

namespace accord {
namespace {

struct RenderOptions {
  std::string scene;
  std::string plan;
  std::string output;
};

// Whether the plan can be drawn in the scene; where it cannot, that is explained.
bool fits_or_explain(const Scene& scene, const Plan& plan, const std::string& path) {
  if (const auto other = other_scene(scene, plan)) {
    std::cerr << fmt::format("{}: note: {}\n", path, *other);
  }
  const std::optional<std::string> wrong = other_robots(scene, plan);
  if (wrong) std::cerr << fmt::format("{}: not a plan for this scene: {}\n", path, *wrong);
  return !wrong;
}

ExitCode run(const RenderOptions& options) {
  refuse_overwriting(options.output, {options.scene, options.plan});
  const std::shared_ptr<const Scene> scene = load_scene_or_explain(options.scene);
  if (!scene) return ExitCode::kBadInput;
  std::optional<Plan> plan;
  if (!options.plan.empty()) {
    plan = load_plan_or_explain(options.plan);
    if (!plan || !fits_or_explain(*scene, *plan, options.plan)) return ExitCode::kBadInput;
  }
  const std::string picture = draw(*scene, plan ? &*plan : nullptr);
  return write_file_or_explain(options.output, picture) ? ExitCode::kSuccess : ExitCode::kBadInput;
}

}  // namespace

void add_render_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command =
      app.add_subcommand("render", "Draw a scene, and the paths of a plan, as an SVG picture");
  command->add_option("SCENE", options->scene, "Scene file (.yaml)")->required();
  command->add_option("PLAN", options->plan, "Plan file (.json)");
  command->add_option("-o,--output", options->output, "Picture to write (.svg); -: print it")
      ->required()
      ->check(output_name());
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
