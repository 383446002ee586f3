#include "tests/contract/disk_faults.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <set>

namespace accord::testing::disk {
namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

std::size_t writes_left = kNever;
std::size_t syncs_left = kNever;
std::size_t writes = 0;
std::set<int> unsynced;  // files

bool used_up(std::size_t& left) {
  if (left == 0) return true;
  if (left != kNever) --left;
  return false;
}

ssize_t watched_write(int file, const void* data, size_t size, off_t offset) {
  if (used_up(writes_left)) {
    errno = ENOSPC;
    return -1;
  }
  ++writes;
  unsynced.insert(file);
  return pwrite(file, data, size, offset);
}

int watched_sync(int file) {
  if (used_up(syncs_left)) {
    errno = EIO;
    return -1;
  }
  unsynced.erase(file);
  return static_cast<int>(syscall(SYS_fdatasync, file));
}

// SQLite lets system calls be replaced by name; which of the two it uses was decided when it was
// built.
const bool replaced = [] {
  sqlite3_vfs* vfs = sqlite3_vfs_find(nullptr);
  for (const char* call : {"pwrite", "pwrite64"}) {
    vfs->xSetSystemCall(vfs, call, reinterpret_cast<sqlite3_syscall_ptr>(&watched_write));
  }
  return true;
}();

}  // namespace

void fail_after_writes(std::size_t count) {
  EXPECT_TRUE(replaced);
  writes_left = count;
}

void fail_after_syncs(std::size_t count) {
  syncs_left = count;
}

void heal() {
  writes_left = kNever;
  syncs_left = kNever;
}

bool all_synced() {
  EXPECT_GT(writes, 0U);
  const bool all = unsynced.empty();
  unsynced.clear();
  writes = 0;
  return all;
}

}  // namespace accord::testing::disk

// What SQLite calls, found here before it is in the C library.
extern "C" int fdatasync(int file) {
  return accord::testing::disk::watched_sync(file);
}
extern "C" int fsync(int file) {
  return accord::testing::disk::watched_sync(file);
}
