#include "client/delegation.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>

namespace accord {
namespace {

ExitCode become(const char* program, char** argv) {
  std::error_code fault;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", fault);
  const std::string path = (self.parent_path() / program).string();
  execv(path.c_str(), argv);
  std::cerr << "accord: cannot start " << path << ": " << std::strerror(errno) << "\n";
  return ExitCode::kBadInput;
}

}  // namespace

void add_delegated_command(CLI::App& app, ExitCode& exit_code, const ServiceCommand& command,
                           char** argv) {
  CLI::App* delegated = app.add_subcommand(command.name, command.description);
  delegated->prefix_command();  // whatever follows is not looked at here, --help neither
  delegated->set_help_flag();
  delegated->callback([argv, &exit_code] { exit_code = become("accord-fleet", argv); });
}

}  // namespace accord
