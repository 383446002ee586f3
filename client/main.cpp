// The `accord` command.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>

#include "client/commands.h"
#include "client/exit_code.h"

namespace {

constexpr const char* kFooter = R"(Exit codes:
  0  solved, proved, or done
  1  a bug in accord, or not enough memory
  2  the command line makes no sense
  3  a file cannot be read or written, or is wrong
  4  there is no plan, or the plan given is refuted
  5  time ran out, or the request was cancelled)";

int run(int argc, char** argv) {
  using accord::ExitCode;
  CLI::App app("Plans collision-free motions for many robots at once, and proves them.", "accord");
  app.require_subcommand(1);
  app.footer(kFooter);
  app.set_version_flag("--version", ACCORD_VERSION);

  ExitCode exit_code = ExitCode::kSuccess;
  accord::add_plan_command(app, exit_code);
  accord::add_verify_command(app, exit_code);
  accord::add_info_command(app, exit_code);
  accord::add_render_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = error.get_exit_code() == 0;
    app.exit(error);
    return static_cast<int>(asked_for_help ? ExitCode::kSuccess : ExitCode::kUsage);
  }
  return static_cast<int>(exit_code);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "accord: out of memory\n";
    return static_cast<int>(accord::ExitCode::kBug);
  } catch (const std::exception& error) {
    std::cerr << "accord: internal error: " << error.what()
              << "\nThis is a bug in accord. Please report it with the scene and the command.\n";
    return static_cast<int>(accord::ExitCode::kBug);
  }
}
