#include "common/transport/dds/shared_memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace accord::dds {
namespace {

namespace fs = std::filesystem;

class SharedMemory : public testing::Test {
 protected:
  SharedMemory() { fs::create_directory(folder_); }
  ~SharedMemory() override { fs::remove_all(folder_); }

  void add(const char* name) { std::ofstream(folder_ / name) << "x"; }

  const fs::path folder_ =
      fs::temp_directory_path() / ("accord-shared-memory-" + std::to_string(getpid()));
  const uid_t me_ = geteuid();
};

TEST_F(SharedMemory, IsOthersWhereAnotherUserHasSegmentsOrPorts) {
  for (const char* name : {"fastrtps_0a1b2c", "fastrtps_port7410", "sem.fastrtps_port7410_mutex"}) {
    add(name);
    EXPECT_TRUE(others_share_memory(folder_, me_ + 1)) << name;
    EXPECT_FALSE(others_share_memory(folder_, me_)) << name;
    fs::remove(folder_ / name);
  }
}

TEST_F(SharedMemory, IsNobodysWhereOtherProgramsHaveFiles) {
  add("sem.something");
  add("pulse-shm-1");
  EXPECT_FALSE(others_share_memory(folder_, me_ + 1));
}

TEST_F(SharedMemory, IsNobodysWhereThereIsNoFolder) {
  EXPECT_FALSE(others_share_memory(folder_ / "none", me_ + 1));
}

}  // namespace
}  // namespace accord::dds
