#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <string_view>

#include "client/doctor/probes/probes.h"

namespace accord {
namespace {

// A file this young may be one whose owner is about to lock it.
constexpr std::time_t kYoung = 2;  // s

std::string path_of(const std::string& name) {
  return std::string(kSharedMemoryFolder) + "/" + name;
}

bool is_made_of(std::string_view text, std::string_view letters) {
  return !text.empty() && text.find_first_not_of(letters) == std::string_view::npos;
}

// What a lock file belongs to, where it is one of Fast DDS's: the name without _el or _sl.
struct Locked {
  std::string name;
  bool is_port = false;
};
std::optional<Locked> locked_by(std::string_view file) {
  constexpr std::string_view kPrefix = "fastrtps_", kPort = "port";
  constexpr std::size_t kSegmentDigits = 16, kPortDigits = 5;
  if (!file.starts_with(kPrefix) || !(file.ends_with("_el") || file.ends_with("_sl"))) {
    return std::nullopt;
  }
  const std::string_view name = file.substr(0, file.size() - 3);
  std::string_view id = name.substr(kPrefix.size());
  const bool is_port = id.starts_with(kPort);
  if (is_port) id.remove_prefix(kPort.size());
  const bool is_one = is_port ? id.size() <= kPortDigits && is_made_of(id, "0123456789")
                              : id.size() == kSegmentDigits && is_made_of(id, "0123456789abcdef");
  if (!is_one) return std::nullopt;
  return Locked{std::string(name), is_port};
}

std::vector<std::string> names_in_folder() {
  std::error_code fault;
  std::vector<std::string> out;
  for (std::filesystem::directory_iterator file(kSharedMemoryFolder, fault), end;
       !fault && file != end; file.increment(fault)) {
    out.push_back(file->path().filename().string());
  }
  std::ranges::sort(out);
  return out;
}

// Whether it is proved that nobody holds the lock.
bool has_no_owner(const std::string& lock_file) {
  const int file = open(path_of(lock_file).c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return false;
  struct stat about {};
  const bool is_old = fstat(file, &about) == 0 && S_ISREG(about.st_mode) &&
                      about.st_mtime + kYoung <= time(nullptr);
  const bool is_free = is_old && flock(file, LOCK_EX | LOCK_NB) == 0;
  close(file);
  return is_free;
}

void add_stale(const std::string& name, SharedMemory& out) {
  struct stat about {};
  if (lstat(path_of(name).c_str(), &about) != 0) return;
  constexpr std::uint64_t kBlock = 512;
  out.stale.push_back(path_of(name));
  out.stale_bytes += static_cast<std::uint64_t>(about.st_blocks) * kBlock;
  out.has_foreign_stale |= about.st_uid != geteuid();
}

// Whether this process listens on a port: it then holds its lock file open.
bool is_own(const std::string& port_file) {
  std::error_code fault;
  for (std::filesystem::directory_iterator file("/proc/self/fd", fault), end; !fault && file != end;
       file.increment(fault)) {
    std::error_code gone;
    if (std::filesystem::read_symlink(file->path(), gone) == port_file + "_el") return true;
  }
  return false;
}

std::optional<std::uint32_t> other_user_of(const std::string& file) {
  struct stat about {};
  const bool is_there = lstat(path_of(file).c_str(), &about) == 0;
  if (!is_there || about.st_uid == geteuid()) return std::nullopt;
  return about.st_uid;
}

}  // namespace

SharedMemory look_at_shared_memory() {
  SharedMemory out;
  struct statvfs room {};
  if (statvfs(kSharedMemoryFolder, &room) != 0) return out;
  out.is_usable = access(kSharedMemoryFolder, W_OK | X_OK) == 0;
  out.bytes = std::uint64_t{room.f_blocks} * room.f_frsize;
  out.free_bytes = std::uint64_t{room.f_bavail} * room.f_frsize;
  for (const std::string& file : names_in_folder()) {
    const auto locked = locked_by(file);
    if (!locked) continue;
    if (!out.other_user) out.other_user = other_user_of(file);
    if (!has_no_owner(file)) {
      if (!locked->is_port) ++out.owned;
      continue;
    }
    add_stale(locked->name, out);
    add_stale(file, out);
    if (locked->is_port) add_stale("sem." + locked->name + "_mutex", out);
  }
  return out;
}

SharedPort look_at_shared_port(std::uint32_t port) {
  const std::string path = path_of("fastrtps_port" + std::to_string(port));
  struct stat about {};
  if (stat(path.c_str(), &about) != 0) return {};
  if (is_own(path)) return {SharedPort::State::kOwn, about.st_uid};
  // To open it is not enough: the other one has to be able to open ours, too.
  const bool is_for_all = (about.st_mode & S_IWOTH) != 0;
  const bool is_closed = about.st_uid != geteuid() && !is_for_all;
  return {is_closed ? SharedPort::State::kDenied : SharedPort::State::kOpen, about.st_uid};
}

}  // namespace accord
