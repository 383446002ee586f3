// What counts where something is written in several places, and what is said of what is wrong.
#include "common/runtime/configuration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

enum class Colour { kRed, kBlue };
constexpr std::array kColours{std::pair<std::string_view, Colour>{"red", Colour::kRed},
                              std::pair<std::string_view, Colour>{"blue", Colour::kBlue}};

class ConfigurationTest : public ::testing::Test {
 protected:
  ConfigurationTest() {
    table_.add("threads", "--threads", threads_, whole_number(1U, 1024U), "Threads");
    table_.add("net.colour", "--colour", colour_, one_of<Colour>(kColours), "Colour");
    table_.add("net.lease", "--lease", lease_, seconds(0, 10), "Lease");
    table_.add_list("net.peers", "--peer", peers_, ipv4_address(), "Peers");
    table_.add_check([this]() -> std::optional<SettingFault> {
      if (lease_ >= 1 || colour_ == Colour::kRed) return std::nullopt;
      return SettingFault{"net.lease", "blue needs 1 s at least"};
    });
  }

  void write(const std::string& text) {
    const std::filesystem::path path = folder_.path() / "a.yaml";
    std::ofstream(path) << text;
    written_.file = path;
  }

  // Without the folder of the file.
  std::vector<std::string> faults_of_file(const std::string& text) {
    write(text);
    std::vector<std::string> faults = configure(table_, written_).file;
    for (std::string& fault : faults) {
      const std::string folder = folder_.path().string() + "/";
      for (auto at = fault.find(folder); at != std::string::npos; at = fault.find(folder)) {
        fault.erase(at, folder.size());
      }
    }
    return faults;
  }

  testing::ScratchFolder folder_;
  unsigned threads_ = 2;
  Colour colour_ = Colour::kRed;
  double lease_ = 0.5;
  std::vector<std::string> peers_{"10.0.0.1"};
  Settings table_;
  Written written_;
};

TEST_F(ConfigurationTest, LeavesDefaultsWhereNothingIsWritten) {
  EXPECT_TRUE(configure(table_, written_).none());
  EXPECT_EQ(threads_, 2U);
  EXPECT_THAT(peers_, ElementsAre("10.0.0.1"));
}

TEST_F(ConfigurationTest, CountsAFlagMoreThanAVariableMoreThanTheFile) {
  write("threads: 3\nnet: {lease: 3, colour: blue}\n");
  written_.variables = {{"ACCORD_THREADS", "4"}, {"ACCORD_NET_LEASE", "4"}};
  written_.flags = {{"--threads", {"5"}}};
  EXPECT_TRUE(configure(table_, written_).none());
  EXPECT_EQ(threads_, 5U);
  EXPECT_EQ(lease_, 4);
  EXPECT_EQ(colour_, Colour::kBlue);
}

TEST_F(ConfigurationTest, ReadsListsInEachPlacesOwnWay) {
  write("net:\n  peers:\n    - 10.0.0.2\n    - \"10.0.0.3\"\n");
  EXPECT_TRUE(configure(table_, written_).none());
  EXPECT_THAT(peers_, ElementsAre("10.0.0.2", "10.0.0.3"));
  written_.variables = {{"ACCORD_NET_PEERS", "10.0.0.4,10.0.0.5"}};
  EXPECT_TRUE(configure(table_, written_).none());
  EXPECT_THAT(peers_, ElementsAre("10.0.0.4", "10.0.0.5"));
  written_.flags = {{"--peer", {"10.0.0.6", "10.0.0.7,10.0.0.8"}}};
  EXPECT_TRUE(configure(table_, written_).none());
  EXPECT_THAT(peers_, ElementsAre("10.0.0.6", "10.0.0.7", "10.0.0.8"));
}

TEST_F(ConfigurationTest, TakesAnEmptyListForNone) {
  write("net: {peers: []}\n");
  EXPECT_TRUE(configure(table_, written_).none());
  EXPECT_THAT(peers_, IsEmpty());
}

TEST_F(ConfigurationTest, TakesAnEmptyVariableForNoneAtAll) {
  written_.variables = {{"ACCORD_THREADS", ""}};
  EXPECT_TRUE(configure(table_, written_).none());
  EXPECT_EQ(threads_, 2U);
}

TEST_F(ConfigurationTest, TakesAnEmptyFileForNoSettings) {
  for (const char* text : {"", "# nothing\n\n  # at all", "---\n"}) {
    EXPECT_THAT(faults_of_file(text), IsEmpty()) << text;
  }
  EXPECT_EQ(threads_, 2U);
}

TEST_F(ConfigurationTest, BlamesLineAndKeyOfTheFileForAllFaultsAtOnce) {
  EXPECT_THAT(
      faults_of_file("threads: many\n"
                     "thread: 3\n"
                     "net:\n"
                     "  colour: green\n"
                     "  lease: \"3\"\n"
                     "  lease: 4\n"
                     "  colr: red\n"
                     "  peers: [10.0.0.2, peer, [1]]\n"),
      ElementsAre("a.yaml:1: threads: expected a whole number from 1 to 1024, not \"many\"",
                  "a.yaml:2: thread: unknown key in the settings; did you mean \"threads\"?",
                  "a.yaml:4: net.colour: expected red or blue, not \"green\"",
                  "a.yaml:5: net.lease: expected a number from 0 to 10 s, not the string \"3\"",
                  "a.yaml:6: net.lease: given twice in net; the first is in line 5",
                  "a.yaml:7: net.colr: unknown key in net; did you mean \"colour\"?",
                  "a.yaml:8: net.peers[1]: expected an IPv4 address, not \"peer\"",
                  "a.yaml:8: net.peers[2]: expected an IPv4 address, not a list of 1"));
}

TEST_F(ConfigurationTest, BlamesValuesOfAnotherKind) {
  EXPECT_THAT(faults_of_file("threads: [3]\nnet:\n  peers: 10.0.0.2\n  lease: ~\n"),
              ElementsAre("a.yaml:1: threads: expected a whole number from 1 to 1024, not a list "
                          "of 1",
                          "a.yaml:3: net.peers: expected a list, each item an IPv4 address, not "
                          "\"10.0.0.2\"",
                          "a.yaml:4: net.lease: expected a number from 0 to 10 s, not nothing"));
  EXPECT_THAT(faults_of_file("net: 3\n"),
              ElementsAre("a.yaml:1: net: expected a map of settings, not \"3\""));
  EXPECT_THAT(faults_of_file("- threads\n"),
              ElementsAre("a.yaml:1: expected a map of settings, not a list of 1"));
  EXPECT_THAT(faults_of_file("verbosity: 3\n"),
              ElementsAre("a.yaml:1: verbosity: unknown key in the settings; expected threads or "
                          "net"));
}

TEST_F(ConfigurationTest, BlamesAFileThatCannotBeRead) {
  written_.file = "/nowhere/a.yaml";
  EXPECT_THAT(configure(table_, written_).file,
              ElementsAre("/nowhere/a.yaml: cannot open \"/nowhere/a.yaml\": no such file"));
}

TEST_F(ConfigurationTest, BlamesVariablesAndFlagsByName) {
  written_.variables = {{"ACCORD_THREADS", "0"}, {"ACCORD_NET_PEERS", "10.0.0.2,,x"}};
  written_.flags = {{"--threads", {"3", "4"}}, {"--colour", {""}}};
  const WrittenFaults faults = configure(table_, written_);
  EXPECT_THAT(faults.usage,
              ElementsAre("ACCORD_THREADS: expected a whole number from 1 to 1024, not \"0\"",
                          "--threads: given 2 times; expected once",
                          "--colour: expected red or blue, not \"\"",
                          "ACCORD_NET_PEERS: expected an IPv4 address, not \"\"",
                          "ACCORD_NET_PEERS: expected an IPv4 address, not \"x\""));
  EXPECT_THAT(faults.file, IsEmpty());
}

TEST_F(ConfigurationTest, BlamesWhatIsOverriddenToo) {
  written_.flags = {{"--threads", {"3"}}};
  EXPECT_THAT(faults_of_file("threads: 0\n"), ::testing::SizeIs(1));
}

TEST_F(ConfigurationTest, WarnsOfVariablesThatNobodyReads) {
  written_.variables = {{"ACCORD_THREAD", "3"}, {"ACCORD_UNHEARD_OF", "3"}, {"PATH", "/bin"}};
  const WrittenFaults faults = configure(table_, written_);
  EXPECT_TRUE(faults.none());
  EXPECT_THAT(faults.warnings,
              ElementsAre("the environment variable ACCORD_THREAD is not used; did you mean "
                          "\"ACCORD_THREADS\"?",
                          "the environment variable ACCORD_UNHEARD_OF is not used"));
}

TEST_F(ConfigurationTest, BlamesWhoeverWroteASettingThatGoesIllWithAnother) {
  EXPECT_THAT(faults_of_file("net:\n  colour: blue\n  lease: 0.1\n"),
              ElementsAre("a.yaml:3: net.lease: blue needs 1 s at least"));
  written_.flags = {{"--lease", {"0.2"}}};
  EXPECT_THAT(configure(table_, written_).usage, ElementsAre("--lease: blue needs 1 s at least"));
}

TEST_F(ConfigurationTest, BlamesTheFileForWhatItLacks) {
  EXPECT_THAT(faults_of_file("net:\n  colour: blue\n"),
              ElementsAre("a.yaml: net.lease: blue needs 1 s at least"));
  written_ = {std::nullopt, {}, {{"--colour", {"blue"}}}};
  lease_ = 0.5;
  EXPECT_THAT(configure(table_, written_).usage, ElementsAre("--lease: blue needs 1 s at least"));
}

TEST(VariableOf, IsTheKeyInCapitals) {
  Setting setting;
  setting.key = "limits.request_bytes";
  EXPECT_EQ(variable_of(setting), "ACCORD_LIMITS_REQUEST_BYTES");
}

}  // namespace
}  // namespace accord
