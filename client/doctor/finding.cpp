#include "client/doctor/finding.h"

#include <array>
#include <cstddef>

namespace accord {

const char* name_of(Severity severity) {
  constexpr std::array kNames{"fine", "warning", "fault"};
  return kNames.at(static_cast<std::size_t>(severity));
}

const char* name_of(Concern concern) {
  constexpr std::array kNames{
      "domain",         "interface",      "shm-small", "shm-stale",        "shm-not-shared",
      "shm-other-user", "socket-buffers", "multicast", "peer-unreachable", "server-unreachable",
      "transport",      "security",       "protocol",  "cluster",          "no-data",
      "clock-skew",     "service",        "workers"};
  static_assert(kNames.size() == static_cast<std::size_t>(Concern::kWorkers) + 1);
  return kNames.at(static_cast<std::size_t>(concern));
}

}  // namespace accord
