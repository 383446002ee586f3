#include "client/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

using ::testing::HasSubstr;
using ::testing::internal::CaptureStderr;
using ::testing::internal::CaptureStdout;
using ::testing::internal::GetCapturedStderr;
using ::testing::internal::GetCapturedStdout;

class Files : public ::testing::Test {
 protected:
  static std::string text_of(const std::filesystem::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::size_t count() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  const testing::ScratchFolder scratch_;
  const std::filesystem::path& folder_ = scratch_.path();
};

TEST_F(Files, AreReplacedAsAWhole) {
  const std::filesystem::path path = folder_ / "plan.json";
  EXPECT_TRUE(write_file_or_explain(path, "the first, a long one"));
  EXPECT_TRUE(write_file_or_explain(path, "second"));
  EXPECT_EQ(text_of(path), "second");
  EXPECT_EQ(count(), 1U) << "nothing unfinished is left";
}

TEST_F(Files, ThatCannotBeWrittenAreExplained) {
  const std::filesystem::path path = folder_ / "nowhere" / "plan.json";
  CaptureStderr();
  EXPECT_FALSE(write_file_or_explain(path, "text"));
  EXPECT_EQ(GetCapturedStderr(),
            path.string() + ": cannot be written: No such file or directory\n");
}

TEST_F(Files, ThatAreFoldersAreLeftAlone) {
  CaptureStderr();
  EXPECT_FALSE(write_file_or_explain(folder_, "text"));
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("cannot be written"));
  EXPECT_EQ(count(), 0U);
}

TEST_F(Files, OfDevicesThatAreFullAreExplained) {
  CaptureStderr();
  EXPECT_FALSE(write_file_or_explain("/dev/full", "text"));
  EXPECT_EQ(GetCapturedStderr(), "/dev/full: cannot be written: No space left on device\n");
}

TEST_F(Files, NamedByADashAreStandardOutput) {
  CaptureStdout();
  EXPECT_TRUE(write_file_or_explain("-", "text"));
  EXPECT_TRUE(flush_output_or_explain());
  EXPECT_EQ(GetCapturedStdout(), "text");
  EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST_F(Files, ThatAreMissingAreExplainedByName) {
  CaptureStderr();
  EXPECT_FALSE(load_scene_or_explain(folder_ / "scene.yaml"));
  EXPECT_FALSE(load_plan_or_explain(folder_ / "plan.json"));
  const std::string said = GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("scene.yaml"));
  EXPECT_THAT(said, HasSubstr("plan.json"));
}

TEST(Output, ThatIsLostIsExplained) {
  std::cout.setstate(std::ios::badbit);  // as an earlier write that failed leaves it
  CaptureStderr();
  EXPECT_FALSE(flush_output_or_explain());
  std::cout.clear();
  EXPECT_EQ(GetCapturedStderr(), "standard output: cannot be written\n");
}

}  // namespace
}  // namespace accord
