// Whether processes can find each other by multicast.
#include <fmt/format.h>

#include <algorithm>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

using Interfaces = std::vector<const Interface*>;

// Those that participants with these options would use.
Interfaces in_use(const Observations& seen) {
  const auto& told = seen.options.interfaces;
  Interfaces out;
  for (const Interface& interface : seen.interfaces) {
    const bool is_told = std::ranges::find(told, interface.ip) != told.end();
    if (interface.is_up && (told.empty() ? !interface.is_loopback : is_told)) {
      out.push_back(&interface);
    }
  }
  return out;
}

std::string name_of(const Interface& interface) {
  return fmt::format("{} ({})", interface.name, interface.ip);
}

bool hears_other_hosts(const Observations& seen) {
  return std::ranges::any_of(seen.as_told.survey.participants,
                             [](const SeenParticipant& peer) { return !peer.is_of_this_host; });
}

std::vector<std::string> mends(const Interfaces& broken, const Interfaces& flagless) {
  std::vector<std::string> out;
  for (const Interface* interface : flagless) {
    out.push_back(fmt::format("ip link set {} multicast on", interface->name));
  }
  if (!broken.empty()) {
    out.emplace_back(
        "iptables -I INPUT -d 239.255.0.1 -j ACCEPT; iptables -I OUTPUT -d 239.255.0.1 "
        "-j ACCEPT    # where a firewall drops it");
  }
  out.emplace_back(
      "--discovery peers --address IP...    # of the coordinator's and the workers' "
      "hosts, for all processes; or --discovery server");
  return out;
}

void judge(const Observations& seen, const Interfaces& used, std::vector<Finding>& out) {
  Interfaces broken, flagless;
  std::vector<std::string> faults;
  for (const Interface* interface : used) {
    if (interface->multicast_fault) {
      broken.push_back(interface);
      faults.push_back(name_of(*interface) + ": " + *interface->multicast_fault);
    } else if (!interface->has_multicast_flag && !interface->is_loopback) {
      flagless.push_back(interface);
      faults.push_back(name_of(*interface) + ": the interface has multicast switched off");
    }
  }
  if (faults.empty()) {
    std::vector<std::string> names;
    for (const Interface* interface : used) names.push_back(name_of(*interface));
    out.push_back(fine(Concern::kMulticast, "comes back through " + in_list(names)));
    return;
  }
  const bool is_fault = faults.size() == used.size() && !hears_other_hosts(seen);
  out.push_back({is_fault ? Severity::kFault : Severity::kWarning, Concern::kMulticast,
                 in_list(faults),
                 "Processes find each other by datagrams to 239.255.0.1, unless they are told "
                 "addresses.",
                 mends(broken, flagless)});
}

}  // namespace

void check_multicast(const Observations& seen, std::vector<Finding>& out) {
  if (!uses_udp(seen.options)) return;
  if (seen.options.discovery != DdsOptions::Discovery::kMulticast) {
    out.push_back(fine(Concern::kMulticast, "not used: processes find each other by addresses"));
    return;
  }
  const Interfaces used = in_use(seen);
  if (!used.empty()) return judge(seen, used, out);
  if (!seen.options.interfaces.empty()) return;  // Concern::kInterface says so
  out.push_back({Severity::kWarning,
                 Concern::kMulticast,
                 "no interface is up but loopback",
                 "Only processes of this machine are found.",
                 {"ip link set eth0 up    # or whatever leads to the others"}});
}

}  // namespace accord
