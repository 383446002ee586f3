#include "client/option_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// What the validator says of a value; empty: it is fine.
std::string said(const CLI::Validator& validator, std::string value) {
  return validator(value);
}

TEST(PlainInteger, IsDigitsAndNothingElse) {
  for (const char* good : {"0", "7", "010", "18446744073709551615"}) {
    EXPECT_EQ(said(plain_integer(), good), "") << good;
  }
  for (const char* bad : {"", "-1", "+1", " 1", "1 ", "0x10", "1e3", "1.0", "18446744073709551616",
                          "soon", "nan", "1'000"}) {
    EXPECT_NE(said(plain_integer(), bad), "") << bad;
  }
}

TEST(PlainInteger, IsDecimalEvenWithALeadingZero) {
  std::string value = "010";
  EXPECT_EQ(plain_integer()(value), "");
  EXPECT_EQ(value, "10");
}

TEST(Seconds, AreFiniteAndInRange) {
  for (const char* good : {"1", "0.5", ".5", "1e3", "0.001"}) {
    EXPECT_EQ(said(seconds_within(1e-3, 1e7), good), "") << good;
  }
  for (const char* bad :
       {"nan", "-nan", "inf", "-inf", "infinity", "0", "-1", "1e8", "1s", "", "soon"}) {
    EXPECT_NE(said(seconds_within(1e-3, 1e7), bad), "") << bad;
  }
}

const std::vector<std::string> kKnown{"query", "prm", "rrt"};

std::string why_not(std::string_view list) {
  try {
    solvers_in(list, kKnown);
  } catch (const CLI::ValidationError& error) {
    return error.what();
  }
  return "";
}

TEST(SolverList, KeepsItsOrder) {
  EXPECT_THAT(solvers_in("prm", kKnown), ElementsAre("prm"));
  EXPECT_THAT(solvers_in("rrt,query,prm", kKnown), ElementsAre("rrt", "query", "prm"));
}

TEST(SolverList, HasNoEmptyItems) {
  for (const char* list : {"", ",", "prm,", ",prm", "prm,,rrt"}) {
    EXPECT_THAT(why_not(list), HasSubstr("a name is empty")) << list;
  }
}

TEST(SolverList, NamesEachOnce) {
  EXPECT_THAT(why_not("prm,rrt,prm"), HasSubstr("\"prm\" is there twice"));
}

TEST(SolverList, NamesOnlyThoseThatExist) {
  EXPECT_THAT(why_not("prm,magic"), HasSubstr("no solver \"magic\"; expected query, prm or rrt"));
}

class Overwriting : public ::testing::Test {
 protected:
  Overwriting() { std::ofstream(scene_) << "a scene"; }

  const testing::ScratchFolder scratch_;
  const std::filesystem::path& folder_ = scratch_.path();
  const std::string scene_ = folder_ / "scene.yaml";
};

TEST_F(Overwriting, IsRefusedByWhateverPathTheFileIsReached) {
  const std::string link = folder_ / "link.json";
  std::filesystem::create_symlink("scene.yaml", link);
  const std::string hard = folder_ / "hard.json";
  std::filesystem::create_hard_link(scene_, hard);
  for (const std::string& output : {scene_, (folder_ / "." / "scene.yaml").string(), link, hard}) {
    EXPECT_THROW(refuse_overwriting(output, {scene_}), CLI::ValidationError) << output;
    EXPECT_THROW(refuse_overwriting(output, {"elsewhere", scene_}), CLI::ValidationError) << output;
  }
}

TEST_F(Overwriting, IsNoConcernOfOtherFilesOrMissingOnes) {
  const std::string other = folder_ / "plan.json";
  EXPECT_NO_THROW(refuse_overwriting(other, {scene_, ""}));
  std::ofstream(other) << "a plan";
  EXPECT_NO_THROW(refuse_overwriting(other, {scene_, ""}));
  EXPECT_NO_THROW(refuse_overwriting("", {scene_, ""}));
  EXPECT_NO_THROW(refuse_overwriting(other, {folder_ / "nowhere.yaml"}));
}

}  // namespace
}  // namespace accord
