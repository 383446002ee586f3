#include "common/transport/dds/shared_memory.h"

#include <sys/stat.h>

#include <string>
#include <system_error>

namespace accord::dds {
namespace {

// Fast DDS's segments, and its ports, whose mutexes are files that begin with "sem.".
bool is_of_fast_dds(const std::string& name) {
  return name.starts_with("fastrtps_") || name.starts_with("sem.fastrtps_");
}

}  // namespace

bool others_share_memory(const std::filesystem::path& folder, uid_t user) {
  std::error_code fault;
  std::filesystem::directory_iterator file(folder, fault);
  for (; !fault && file != std::filesystem::directory_iterator(); file.increment(fault)) {
    if (!is_of_fast_dds(file->path().filename().string())) continue;
    struct stat what = {};
    // One that has gone meanwhile is nobody's.
    if (lstat(file->path().c_str(), &what) == 0 && what.st_uid != user) return true;
  }
  return false;
}

}  // namespace accord::dds
