// Whether /dev/shm has room for what a process sends, and what dead ones have left in it.
#include <fmt/format.h>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

// A segment's own bookkeeping, and the ports that a participant listens on.
constexpr std::uint64_t kBesides = std::uint64_t{1} << 20;
constexpr std::uint64_t kMebi = std::uint64_t{1} << 20;

std::string room_of(const SharedMemory& memory) {
  return fmt::format("{} has {}, {} of it free", kSharedMemoryFolder, in_mebibytes(memory.bytes),
                     in_mebibytes(memory.free_bytes));
}

std::vector<std::string> mends_of_room(const Observations& seen, std::uint64_t need) {
  const std::uint64_t more =
      (seen.memory.bytes + need - std::min(need, seen.memory.free_bytes)) / kMebi + 1;
  std::vector<std::string> out;
  if (!seen.memory.stale.empty()) out.emplace_back("fastdds shm clean");
  out.push_back(fmt::format("mount -o remount,size={}m {}", more, kSharedMemoryFolder));
  out.push_back(fmt::format("docker run --shm-size={}m ...    # shm_size in a compose file", more));
  if (seen.memory.free_bytes > 2 * kMebi) {
    out.push_back(fmt::format("--dds-segment-bytes {}MiB",
                              std::max(seen.memory.free_bytes / kMebi / 2, std::uint64_t{1})));
  }
  out.emplace_back("--transport udp");
  return out;
}

void check_room(const Observations& seen, std::vector<Finding>& out) {
  const SharedMemory& memory = seen.memory;
  if (!memory.is_usable) {
    out.push_back(
        {Severity::kFault,
         Concern::kShmSmall,
         fmt::format("no file can be made in {}", kSharedMemoryFolder),
         "Shared memory is where processes of one machine leave their messages.",
         {fmt::format("mount -t tmpfs -o size=256m,mode=1777 tmpfs {}", kSharedMemoryFolder),
          "--transport udp"}});
    return;
  }
  const std::uint64_t a_worker = seen.options.segment_bytes + kBesides;
  if (memory.free_bytes >= 2 * a_worker) {
    out.push_back(fine(Concern::kShmSmall, room_of(memory)));
    return;
  }
  const bool has_room = memory.free_bytes >= a_worker;
  const std::string need = in_mebibytes(seen.options.segment_bytes);
  // Those that have started have their room already.
  const bool is_fault = !has_room && memory.owned == 0;
  out.push_back({is_fault ? Severity::kFault : Severity::kWarning, Concern::kShmSmall,
                 fmt::format("{}; a worker takes {} (dds.segment_bytes), a coordinator twice that",
                             room_of(memory), need),
                 "A process that finds no room for its segment is killed as it starts: \"Bus "
                 "error\" (SIGBUS).",
                 mends_of_room(seen, 2 * a_worker)});
}

void check_stale(const Observations& seen, std::vector<Finding>& out) {
  const SharedMemory& memory = seen.memory;
  if (memory.stale.empty()) {
    out.push_back(fine(Concern::kShmStale,
                       fmt::format("nothing in {} is without an owner; {} segments are in use",
                                   kSharedMemoryFolder, memory.owned)));
    return;
  }
  const std::string sudo = memory.has_foreign_stale && seen.user != 0 ? "sudo " : "";
  std::string remove = sudo + "rm -f";
  for (const std::string& file : memory.stale) remove += " " + file;
  Finding finding{
      Severity::kWarning,
      Concern::kShmStale,
      fmt::format("{} files of processes that are dead, {} in all: {}", memory.stale.size(),
                  in_mebibytes(memory.stale_bytes), in_list(memory.stale)),
      "What a killed process leaves stays until the machine is restarted, and the next "
      "ones have less room.",
      {sudo + "fastdds shm clean"}};
  constexpr std::size_t kLongestCommand = 2000;
  if (remove.size() < kLongestCommand) finding.mend.push_back(std::move(remove));
  out.push_back(std::move(finding));
}

}  // namespace

void check_shared_memory(const Observations& seen, std::vector<Finding>& out) {
  if (!uses_shared_memory(seen.options)) return;
  check_room(seen, out);
  check_stale(seen, out);
}

}  // namespace accord
