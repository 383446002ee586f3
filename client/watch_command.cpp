// accord watch: what a service does, as it goes on.
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <string_view>

#include "client/commands.h"
#include "client/interrupt.h"
#include "client/service_commands.h"
#include "client/service_port.h"
#include "client/watch/change_lines.h"
#include "client/watch/first_picture.h"
#include "client/watch/live_screen.h"
#include "client/watch/screen.h"

namespace accord {
namespace {

using namespace std::chrono_literals;

constexpr auto kTurn = 100ms;  // how soon a signal, a change or a terminal's new size is heeded
constexpr WatchTime kRedraw = 500ms;  // where nothing changes but the time

struct CommandOptions {
  ServiceOptions service;
  Patience patience;
  bool json = false;
  bool once = false;
};

ExitCode explain(const Patience& patience) {
  explain_no_service(patience);
  return ExitCode::kNoService;
}

ChangeLines::As as_of(const CommandOptions& options) {
  return options.json ? ChangeLines::As::kJson : ChangeLines::As::kText;
}

ExitCode show_once(FleetClientPort& port, const CommandOptions& options) {
  WatchedFleet fleet;
  const std::atomic<bool> never{false};
  if (!listen_for_first_picture(port, fleet, options.patience.duration(), never)) {
    return explain(options.patience);
  }
  if (options.json) {
    ChangeLines(std::cout, as_of(options)).write_all(fleet, watch_now());
    return ExitCode::kSuccess;
  }
  const ScreenSize size{stdout_size().width, kAnyWidth};
  for (const std::string& line : screen_of(fleet, watch_now(), size)) std::cout << line << "\n";
  return ExitCode::kSuccess;
}

ExitCode write_changes(FleetClientPort& port, const CommandOptions& options,
                       const std::atomic<bool>& stop) {
  WatchedFleet fleet;
  ChangeLines lines(std::cout, as_of(options));
  if (!listen_for_first_picture(port, fleet, options.patience.duration(), stop)) {
    return stop ? ExitCode::kSuccess : explain(options.patience);
  }
  lines.write_all(fleet, watch_now());
  while (!stop && std::cout) {
    port.wait(kTurn);
    take_all(port, fleet, [&lines](const WatchedFleet::Change& change) {
      lines.write(change, watch_now(), utc_now());
    });
  }
  return ExitCode::kSuccess;
}

// Draws where something may have changed, and from time to time.
class Drawing {
 public:
  explicit Drawing(const WatchedFleet& fleet) : fleet_(fleet) {}

  void turn(bool has_changed) {
    const ScreenSize size = stdout_size();
    const WatchTime now = watch_now();
    const bool is_resized = size.width != size_.width || size.height != size_.height;
    if (!has_changed && !is_resized && drawn_ && now - *drawn_ < kRedraw) return;
    size_ = size;
    drawn_ = now;
    const auto lines = screen_of(fleet_, now, size);
    fleet_.service() ? screen_.draw(lines) : screen_.draw_for_now(lines);
  }

 private:
  const WatchedFleet& fleet_;
  LiveScreen screen_{std::cout};
  ScreenSize size_;
  std::optional<WatchTime> drawn_;
};

ExitCode draw(FleetClientPort& port, const CommandOptions& options, const std::atomic<bool>& stop) {
  WatchedFleet fleet;
  bool has_service = true;
  {
    Drawing drawing(fleet);
    has_service = listen_for_first_picture(port, fleet, options.patience.duration(), stop,
                                           [&drawing] { drawing.turn(true); });
    while (has_service && !stop && std::cout) {
      port.wait(kTurn);
      bool has_changed = false;
      take_all(port, fleet, [&has_changed](const WatchedFleet::Change&) { has_changed = true; });
      drawing.turn(has_changed);
    }
  }
  return has_service || stop ? ExitCode::kSuccess : explain(options.patience);
}

// A terminal that can do no more than a printer ("dumb") gets lines.
bool can_draw() {
  const char* terminal = std::getenv("TERM");
  return stdout_is_a_terminal() && terminal != nullptr && std::string_view(terminal) != "dumb";
}

ExitCode run(CommandOptions& options) {
  const auto port = open_port_or_explain(options.service.resolve(), HeardPlans::kAllOutcomes);
  if (!port) return ExitCode::kNoService;
  if (options.once) return show_once(*port, options);
  // To be ended so is what it waits for.
  const CancelOnSignal on_signal;
  return !options.json && can_draw() ? draw(*port, options, on_signal.cancelled())
                                     : write_changes(*port, options, on_signal.cancelled());
}

}  // namespace

void add_watch_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<CommandOptions>();
  CLI::App* command = app.add_subcommand(kWatchCommand.name, kWatchCommand.description);
  command->add_flag("--once", options->once, "Show them once, and end");
  command->add_flag("--json", options->json, "An object of JSON a line instead of table or text");
  options->patience.add_to(*command, "Seconds until a service has to have answered");
  options->service.add_to(*command);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
