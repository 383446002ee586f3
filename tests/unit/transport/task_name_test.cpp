#include "common/transport/task_name.h"

#include <gtest/gtest.h>

namespace accord {
namespace {

TEST(TaskName, TellsTheRequestFromTheTaskInIt) {
  EXPECT_EQ(task_name((std::uint64_t{0x5f3a9c21} << 32U) + 17), "5f3a9c21-17");
  EXPECT_EQ(task_name(UINT64_MAX), "ffffffff-4294967295");
  EXPECT_EQ(task_name(3), "0-3");
}

}  // namespace
}  // namespace accord
