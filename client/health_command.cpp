// accord health: asks a process of Accord on this machine how it is, for whoever starts it anew
// where it is not well (deploy/docker-compose.yml).
#include <iostream>
#include <memory>

#include "client/commands.h"
#include "client/service_commands.h"
#include "client/setting_flags.h"
#include "client/terminal_text.h"
#include "common/runtime/metrics_endpoint.h"

namespace accord {
namespace {

constexpr auto kPatience = std::chrono::seconds(5);
constexpr std::size_t kWidest = 1000;

struct CommandOptions {
  CommandOptions() { add_metrics_settings(table, metrics); }

  MetricsOptions metrics;
  Settings table;
  SettingFlags flags;
  bool ready = false;
};

ExitCode explain(const std::string& why) {
  std::cerr << "accord: " << terminal_text(why, kWidest) << "\n";
  return ExitCode::kNoService;
}

ExitCode run(CommandOptions& options) {
  options.flags.resolve(options.table);
  const auto port = metrics_port_of(options.metrics);
  if (!port) return explain(port.error());
  // Who serves at all addresses serves at this one.
  const bool is_any = options.metrics.address == "0.0.0.0";
  const auto answer = ask_health(is_any ? "127.0.0.1" : options.metrics.address, *port,
                                 options.ready ? "/readyz" : "/healthz", kPatience);
  if (!answer) return explain(answer.error());
  if (!answer->is_well) {
    return explain(std::string(options.ready ? "not ready: " : "not well: ") + answer->text);
  }
  std::cout << terminal_text(answer->text, kWidest) << "\n";
  return ExitCode::kSuccess;
}

}  // namespace

void add_health_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<CommandOptions>();
  CLI::App* command = app.add_subcommand(kHealthCommand.name, kHealthCommand.description);
  command->add_flag("--ready", options->ready, "Whether it can work just now, not only is alive");
  options->flags.add_to(*command, options->table, "Process");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
