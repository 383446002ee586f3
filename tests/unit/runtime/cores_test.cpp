// A container or a service with a share of the machine gets as many threads as that share can run.
#include "common/runtime/cores.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

class Cores : public ::testing::Test {
 protected:
  void limit(const std::string& group, const std::string& cpu_max) const {
    std::filesystem::create_directories(folder_.path() / group);
    std::ofstream(folder_.path() / group / "cpu.max") << cpu_max;
  }
  unsigned within(const std::string& group) const { return cores_within(group, folder_.path(), 8); }

  testing::ScratchFolder folder_;
};

TEST_F(Cores, AreTheMachinesWhereNothingLimitsThem) {
  EXPECT_EQ(within("a/b"), 8U);
  limit("a/b", "max 100000\n");
  EXPECT_EQ(within("a/b"), 8U);
  EXPECT_GE(cores(), 1U);
}

TEST_F(Cores, AreAsManyAsTheShareMakes) {
  limit("a", "300000 100000\n");
  EXPECT_EQ(within("a"), 3U);
  limit("a", "250000 100000\n");
  EXPECT_EQ(within("a"), 3U) << "a part of one takes a thread";
  limit("a", "10000 100000\n");
  EXPECT_EQ(within("a"), 1U);
  limit("a", "6400000 100000\n");
  EXPECT_EQ(within("a"), 8U) << "never more than there are";
}

TEST_F(Cores, AreLimitedByEveryGroupAround) {
  limit("a/b", "400000 100000\n");
  limit("a", "200000 100000\n");
  EXPECT_EQ(within("a/b"), 2U);
  EXPECT_EQ(within("/a/b"), 2U);
  limit("", "100000 100000\n");
  EXPECT_EQ(within("a/b"), 1U) << "in a container its group is the root";
}

TEST_F(Cores, AreTheMachinesWhereTheShareMakesNoSense) {
  for (const char* wrong : {"", "many", "100000", "100000 0", "-1 100000"}) {
    limit("a", wrong);
    EXPECT_EQ(within("a"), 8U) << wrong;
  }
}

}  // namespace
}  // namespace accord
