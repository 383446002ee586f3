#include "client/application.h"

#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "client/files.h"
#include "client/interrupt.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr const char* kFooter = R"(Exit codes:
  0  solved, proved, or done
  1  a bug in accord, or not enough memory
  2  the command line makes no sense
  3  a file cannot be read or written, or is wrong; or a service rejects a request, or knows none
     of that id
  4  no plan was found by a search that went as far as it goes, or the plan given is refuted
  5  time ran out, or the request was cancelled
  6  no planning service answers, or it is not well
  7  accord doctor has found what stops data or plans)";

// What to say of a word in the place of a command that is none; CLI11 would only say that a command
// is missing.
std::optional<std::string> unknown_command(const CLI::App& app) {
  const std::vector<std::string> left = app.remaining();
  if (left.empty() || left.front().starts_with('-')) return std::nullopt;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  const std::vector<std::string_view> commands(names.begin(), names.end());
  return "there is no command " + in_quotes(left.front()) + "; expected " + alternatives(commands);
}

ExitCode explain(const CLI::App& app, const CLI::ParseError& error) {
  const bool asked_for_help = error.get_exit_code() == 0;
  const std::optional<std::string> unknown = asked_for_help ? std::nullopt : unknown_command(app);
  if (unknown) {
    app.exit(CLI::ValidationError(*unknown));
  } else {
    app.exit(error);
  }
  return asked_for_help ? ExitCode::kSuccess : ExitCode::kUsage;
}

ExitCode run(int argc, char** argv, const std::function<void(CLI::App&, ExitCode&)>& add_commands) {
  CLI::App app("Plans collision-free motions for many robots at once, and proves them.", "accord");
  app.require_subcommand(1);
  app.footer(kFooter);
  app.set_version_flag("--version", ACCORD_VERSION);

  ExitCode exit_code = ExitCode::kSuccess;
  add_commands(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return explain(app, error);
  }
  return exit_code;
}

ExitCode explain_internal(const std::exception& error) {
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  if (system != nullptr && system->code() == std::errc::resource_unavailable_try_again) {
    std::cerr << "accord: out of memory or threads\n";
  } else {
    std::cerr << "accord: internal error: " << error.what()
              << "\nThis is a bug in accord. Please report it with the scene and the command.\n";
  }
  return ExitCode::kBug;
}

}  // namespace

int run_application(int argc, char** argv,
                    const std::function<void(CLI::App&, ExitCode&)>& add_commands) {
  end_on_signals();
  try {
    const ExitCode exit_code = run(argc, argv, add_commands);
    // Whatever a command found out is lost if what it printed is.
    const bool printed = flush_output_or_explain();
    return static_cast<int>(printed ? exit_code : ExitCode::kBadInput);
  } catch (const std::bad_alloc&) {
    std::cerr << "accord: out of memory\n";
    return static_cast<int>(ExitCode::kBug);
  } catch (const std::exception& error) {
    return static_cast<int>(explain_internal(error));
  }
}

}  // namespace accord
