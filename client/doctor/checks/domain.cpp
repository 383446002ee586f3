// Whether this process could join the domain as it was told to.
#include <fmt/format.h>

#include <algorithm>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

std::string addresses_of(const Observations& seen) {
  std::vector<std::string> texts;
  for (const Interface& interface : seen.interfaces) {
    if (interface.is_up) texts.push_back(fmt::format("{} ({})", interface.ip, interface.name));
  }
  return in_list(texts);
}

bool is_here(const Observations& seen, const std::string& ip) {
  return std::ranges::any_of(seen.interfaces, [&ip](const Interface& interface) {
    return interface.ip == ip && interface.is_up;
  });
}

const char* ways_of(const Observations& seen) {
  switch (seen.options.transport) {
    case DdsOptions::Transport::kSharedMemory:
      return "shared memory";
    case DdsOptions::Transport::kUdp:
      return "UDP";
    case DdsOptions::Transport::kBoth:
      break;
  }
  return leaves_shared_memory(seen) ? "UDP" : "shared memory and UDP";
}

void check_interfaces(const Observations& seen, std::vector<Finding>& out) {
  std::vector<std::string> foreign;
  for (const std::string& ip : seen.options.interfaces) {
    if (!is_here(seen, ip)) foreign.push_back(ip);
  }
  if (foreign.empty()) {
    out.push_back(fine(Concern::kInterface, "this machine has " + addresses_of(seen)));
    return;
  }
  Finding finding{Severity::kFault,
                  Concern::kInterface,
                  fmt::format("told to use {}, which is no address of this machine that is up; "
                              "it has {}",
                              in_list(foreign), addresses_of(seen)),
                  "A process that is kept to addresses which are not its machine's reaches nobody.",
                  {}};
  for (const Interface& interface : seen.interfaces) {
    if (interface.is_up && !interface.is_loopback) {
      finding.mend.push_back("--interface " + interface.ip);
    }
  }
  finding.mend.emplace_back("unset ACCORD_DDS_INTERFACES");
  out.push_back(std::move(finding));
}

}  // namespace

void check_domain(const Observations& seen, std::vector<Finding>& out) {
  check_interfaces(seen, out);
  const DdsOptions& options = seen.options;
  if (seen.as_told.join_fault.empty()) {
    out.push_back(
        fine(Concern::kDomain, fmt::format("joined domain {}, cluster \"{}\", by {}",
                                           options.domain, options.cluster, ways_of(seen))));
    return;
  }
  const bool is_told = std::ranges::any_of(out, [](const Finding& finding) {
    return finding.severity == Severity::kFault;  // of the interfaces: that is why
  });
  if (is_told) return;
  out.push_back({Severity::kFault,
                 Concern::kDomain,
                 seen.as_told.join_fault,
                 "A process with these settings cannot start, or reaches nobody.",
                 {"accord doctor --transport udp    # whether UDP alone works"}});
}

}  // namespace accord
