// accord replay: tries a task again that a service could not get solved.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "client/commands.h"
#include "client/counted.h"
#include "client/engine/replay.h"
#include "client/interrupt.h"
#include "client/option_values.h"
#include "client/table.h"
#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/words.h"
#include "common/runtime/log.h"

namespace accord {
namespace {

struct ReplayOptions {
  std::string file;
  double timeout = 0;  // s; 0: none
  LogLevel log = LogLevel::kWarning;
};

std::optional<RecordedTask> load_or_explain(const std::string& path) {
  const auto text = read_file(path, limits::kTaskRecordBytes);
  if (!text) {
    std::cerr << text.error() << '\n';
    return std::nullopt;
  }
  auto task =
      decode_task_record({reinterpret_cast<const std::uint8_t*>(text->data()), text->size()});
  if (task) return std::move(*task);
  std::cerr << path << ": " << task.error() << '\n';
  return std::nullopt;
}

// "8.250 s", or "the end".
std::string instant(double t) {
  return std::isinf(t) ? "the end" : fmt::format("{:.3f} s", t);
}

// "a crowd of 12 robots".
std::string kind_of(const Subproblem& subproblem) {
  const std::size_t robots = subproblem.tasks.size();
  if (robots == 1 && subproblem.outsiders.empty()) return "a robot on its own";
  std::string out = counted(robots, "robot");
  if (subproblem.is_crowd()) out = "a crowd of " + out;
  if (subproblem.lockstep) out = "a crowd in lockstep of " + out;
  return subproblem.whole ? out + ", from start to goal" : out;
}

template <class Entry>
std::string names_of(const Scene& scene, const std::vector<Entry>& entries) {
  constexpr std::size_t kMost = 8;
  if (entries.empty()) return "none";
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(entries.size(), kMost); ++i) {
    names.push_back(scene.robot(entries[i].robot).name);
  }
  std::string out = fmt::format("{}", fmt::join(names, ", "));
  if (entries.size() > kMost) out += fmt::format(" and {} more", entries.size() - kMost);
  return out;
}

void print_task(const RecordedTask& task) {
  const Subproblem& subproblem = task.subproblem;
  Table table;
  table.add("scene", task.scene->name);
  table.add("task", kind_of(subproblem));
  table.add("robots", names_of(*task.scene, subproblem.tasks));
  table.add("window", fmt::format("from {} to {}, looks ahead to {}", instant(subproblem.from),
                                  instant(subproblem.to), instant(subproblem.horizon)));
  table.add("outsiders", names_of(*task.scene, subproblem.outsiders));
  table.add("solvers", fmt::format("{}", fmt::join(task.solvers, ", ")));
  if (!task.why.empty()) table.add("kept because", in_quotes(task.why, limits::kWhyBytes));
  // What follows may crash, as it did elsewhere.
  std::cout << table.str() << std::flush;
}

void log_details(const RecordedTask& task) {
  for (const Task& one : task.subproblem.tasks) {
    log(LogLevel::kDebug,
        fmt::format("{}: from ({}) to ({}), arrives at {} so far and {}",
                    task.scene->robot(one.robot).name, fmt::join(one.start, ", "),
                    fmt::join(one.goal, ", "), instant(one.to),
                    one.goes_on() ? "goes on" : "stays there"),
        {});
  }
  for (const Outsider& outsider : task.subproblem.outsiders) {
    log(LogLevel::kDebug,
        fmt::format("{}: avoided until {}", task.scene->robot(outsider.robot).name,
                    instant(outsider.until)),
        {});
  }
}

std::string outcome_text(const Replay& replay) {
  const std::string solver = replay.resolution.solver;
  switch (replay.outcome) {
    case Replay::Outcome::kSolved:
      return "solved by " + solver + ", and the resolution holds";
    case Replay::Outcome::kImproved:
      return fmt::format("improved by {}, but for {}, and the resolution holds", solver,
                         counted(replay.resolution.left.size(), "robot"));
    case Replay::Outcome::kExhausted:
      return "exhausted: no solver finds a resolution";
    case Replay::Outcome::kRefused:
      return fmt::format("solved by {}, but the resolution does not hold: {}", solver,
                         replay.fault);
    case Replay::Outcome::kStopped:
      break;
  }
  return "stopped before it was solved";
}

ExitCode exit_code_of(Replay::Outcome outcome) {
  switch (outcome) {
    case Replay::Outcome::kSolved:
    case Replay::Outcome::kImproved:
      return ExitCode::kSuccess;
    case Replay::Outcome::kExhausted:
      return ExitCode::kInfeasible;
    case Replay::Outcome::kRefused:
      return ExitCode::kBug;
    case Replay::Outcome::kStopped:
      return ExitCode::kTimeout;
  }
  return ExitCode::kBug;
}

ExitCode run(const ReplayOptions& options) {
  start_log("accord", {options.log, LogFormat::kText});
  const std::optional<RecordedTask> task = load_or_explain(options.file);
  if (!task) return ExitCode::kBadInput;
  print_task(*task);
  log_details(*task);
  std::optional<double> timeout;
  if (options.timeout > 0) timeout = options.timeout;
  const CancelOnSignal on_signal;
  const auto replayed = replay(*task, timeout, &on_signal.cancelled());
  if (!replayed) {
    std::cerr << options.file << ": " << replayed.error() << '\n';
    return ExitCode::kBadInput;
  }
  const Effort& effort = replayed->resolution.effort;
  Table table;
  table.add("outcome", outcome_text(*replayed));
  table.add("effort",
            fmt::format("{} searches, {} expansions, {} samples, {} motion checks", effort.searches,
                        effort.expansions, effort.samples, effort.motion_checks));
  table.add("took", fmt::format("{:.3f} s", replayed->seconds));
  std::cout << table.str();
  return exit_code_of(replayed->outcome);
}

}  // namespace

void add_replay_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand(
      "replay", "Try a task again that a service has kept because nobody could solve it");
  command->add_option("FILE", options->file, "Recorded task")->required();
  command->add_option("-t,--timeout", options->timeout, "Give up after so many seconds")
      ->check(seconds_within(1e-3, 1e7));
  const std::map<std::string, LogLevel> levels(kLogLevels.begin(), kLogLevels.end());
  command
      ->add_option("--log", options->log,
                   "Least level of what is logged to stderr; debug: a line for each robot and for "
                   "each solver that is tried")
      ->transform(CLI::CheckedTransformer(levels));
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace accord
