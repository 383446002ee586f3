#include "common/runtime/cores.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

namespace accord {
namespace {

// cpu.max: "QUOTA PERIOD" in microseconds, or "max PERIOD".
std::optional<unsigned> cores_of(const std::filesystem::path& group, unsigned machine) {
  std::ifstream file(group / "cpu.max");
  std::uint64_t quota = 0;
  std::uint64_t period = 0;
  if (!(file >> quota >> period) || period == 0) return std::nullopt;
  const std::uint64_t share = quota / period + (quota % period > 0 ? 1 : 0);
  return static_cast<unsigned>(std::clamp<std::uint64_t>(share, 1, machine));
}

// Of the line "0::/system.slice/accord-worker.service"; the root where there is none.
std::filesystem::path own_cgroup(const std::filesystem::path& file) {
  constexpr std::string_view kUnified = "0::/";
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kUnified)) return line.substr(kUnified.size());
  }
  return {};
}

}  // namespace

unsigned cores() {
  const unsigned machine = std::max(1U, std::thread::hardware_concurrency());
  return cores_within(own_cgroup("/proc/self/cgroup"), "/sys/fs/cgroup", machine);
}

unsigned cores_within(const std::filesystem::path& cgroup, const std::filesystem::path& root,
                      unsigned machine) {
  // Each level limits those below it.
  std::filesystem::path level = root;
  unsigned out = cores_of(level, machine).value_or(machine);
  for (const auto& part : cgroup.relative_path()) {
    level /= part;
    out = std::min(out, cores_of(level, machine).value_or(machine));
  }
  return out;
}

}  // namespace accord
