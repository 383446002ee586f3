// How a service's command line is read, and what it answers.
#include "common/runtime/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

using ::testing::HasSubstr;

class CommandLineTest : public ::testing::Test {
 protected:
  CommandLineTest() {
    table_.add("threads", "--threads", threads_, whole_number(1U, 1024U), "Threads to use");
    table_.add("store.journal", "--journal", journal_, path_or_none("a file", "FILE"), "Journal");
    table_.add_list("net.peers", "--peer", peers_, ipv4_address(), "Peers to ask");
  }

  Start read(std::vector<const char*> words) {
    words.insert(words.begin(), "/usr/bin/program");
    return read_command_line({"program", "Does things.", "1.2.3"}, table_,
                             static_cast<int>(words.size()), words.data(), environment_);
  }

  std::string file(const std::string& text) {
    const auto path = folder_.path() / "a.yaml";
    std::ofstream(path) << text;
    return path.string();
  }

  testing::ScratchFolder folder_;
  unsigned threads_ = 2;
  std::string journal_;
  std::vector<std::string> peers_;
  Settings table_;
  std::map<std::string, std::string> environment_;
};

TEST_F(CommandLineTest, SetsWhatItsFlagsSay) {
  const Start start =
      read({"--threads=3", "--peer", "10.0.0.1", "--journal", "x.db", "--peer", "10.0.0.2"});
  EXPECT_EQ(start.end, std::nullopt);
  EXPECT_EQ(start.errors + start.output, "");
  EXPECT_EQ(threads_, 3U);
  EXPECT_EQ(journal_, "x.db");
  EXPECT_THAT(peers_, ::testing::ElementsAre("10.0.0.1", "10.0.0.2"));
}

TEST_F(CommandLineTest, ReadsTheFileThatAFlagOrAVariableNames) {
  const std::string path = file("threads: 7\n");
  EXPECT_EQ(read({"--config", path.c_str()}).end, std::nullopt);
  EXPECT_EQ(threads_, 7U);
  threads_ = 2;
  environment_ = {{"ACCORD_CONFIG", path}};
  const Start start = read({});
  EXPECT_EQ(start.end, std::nullopt);
  EXPECT_TRUE(start.warnings.empty());
  EXPECT_EQ(threads_, 7U);
  EXPECT_EQ(read({"--config", "/nowhere"}).end, ProcessExit::kBadFile) << "a flag counts more";
}

TEST_F(CommandLineTest, EndsWithOneCodeForUsageAndAnotherForTheFile) {
  const std::string path = file("threads: 0\n");
  const std::string of_file = path +
                              ":1: threads: expected a whole number from 1 to 1024, not "
                              "\"0\"\n";
  Start start = read({"--config", path.c_str()});
  EXPECT_EQ(start.end, ProcessExit::kBadFile);
  EXPECT_EQ(start.errors, of_file);
  start = read({"--config", path.c_str(), "--threads", "x"});
  EXPECT_EQ(start.end, ProcessExit::kUsage);
  EXPECT_EQ(start.errors, "--threads: expected a whole number from 1 to 1024, not \"x\"\n" +
                              of_file + "Run program --help for more information.\n");
}

TEST_F(CommandLineTest, BlamesUnknownFlagsAndWords) {
  const Start start =
      read({"--thread", "3", "--jornal=x", "loose", "--config", "", "--config", ""});
  EXPECT_EQ(start.end, ProcessExit::kUsage);
  EXPECT_THAT(start.errors, HasSubstr("--thread: unknown flag; did you mean \"--threads\"?\n"
                                      "--jornal: unknown flag; did you mean \"--journal\"?\n"
                                      "\"loose\": expected a flag\n"
                                      "--config: given 2 times; expected once\n"));
}

TEST_F(CommandLineTest, BlamesAFlagWithoutItsValue) {
  const Start start = read({"--threads"});
  EXPECT_EQ(start.end, ProcessExit::kUsage);
  EXPECT_THAT(start.errors, HasSubstr("--threads: "));
}

TEST_F(CommandLineTest, LeavesOddTextsAsTheyAre) {
  EXPECT_EQ(read({"--journal", "[a,b]"}).end, std::nullopt);
  EXPECT_EQ(journal_, "[a,b]");
  EXPECT_THAT(read({"--journal", ""}).errors,
              HasSubstr("--journal: expected the path of a file, or none, not \"\"\n"));
}

TEST_F(CommandLineTest, HelpSaysForEverySettingWhatItIsAndWhereItCanBeSet) {
  const Start start = read({"--help"});
  EXPECT_EQ(start.end, ProcessExit::kEnded);
  EXPECT_THAT(start.output, HasSubstr("Does things."));
  EXPECT_THAT(start.output, HasSubstr("--threads N"));
  for (const char* line : {"Threads to use\n", "a whole number from 1 to 1024\n",
                           "[default: 2; in the file: threads; ACCORD_THREADS]\n",
                           "an IPv4 address; may be repeated\n",
                           "[default: none; in the file: net.peers; ACCORD_NET_PEERS]\n",
                           "  4  what is needed of the machine is not to be had"}) {
    EXPECT_THAT(start.output, HasSubstr(line));
  }
}

TEST_F(CommandLineTest, SaysItsVersion) {
  const Start start = read({"--version"});
  EXPECT_EQ(start.end, ProcessExit::kEnded);
  EXPECT_EQ(start.output, "1.2.3\n");
}

}  // namespace
}  // namespace accord
