// The command lines of what asks a service: what is wrong with them is said before anything is
// asked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/commands.h"

namespace accord {
namespace {

using testing::HasSubstr;

class ServiceCommands : public testing::Test {
 protected:
  ServiceCommands() {
    add_watch_command(app_, exit_code_);
    add_cancel_command(app_, exit_code_);
    add_workers_command(app_, exit_code_);
  }
  std::string fault_of(const std::string& line) {
    try {
      app_.parse(line);
    } catch (const CLI::ParseError& error) {
      return error.what();
    }
    return "";
  }

  CLI::App app_;
  ExitCode exit_code_ = ExitCode::kSuccess;
};

TEST_F(ServiceCommands, RefuseWhatMakesNoSense) {
  EXPECT_THAT(fault_of("cancel"), HasSubstr("ID is required"));
  EXPECT_THAT(fault_of("cancel good b@d"), HasSubstr("1 to 128 letters"));
  EXPECT_THAT(fault_of("workers --patience 0"), HasSubstr("--patience"));
  EXPECT_THAT(fault_of("workers --once"), HasSubstr("--once"));
  EXPECT_THAT(fault_of("watch --domain 500"), HasSubstr("--domain"));
  EXPECT_THAT(fault_of("watch something"), HasSubstr("something"));
}

TEST_F(ServiceCommands, SayAllTheirOptions) {
  for (const CLI::App* command : app_.get_subcommands({})) {
    const std::string help = command->help();
    for (const char* option : {"--patience", "--domain", "--cluster", "--transport", "--discovery",
                               "--address", "--interface"}) {
      EXPECT_THAT(help, HasSubstr(option)) << command->get_name();
    }
  }
}

}  // namespace
}  // namespace accord
