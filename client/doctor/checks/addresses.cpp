// Whether the addresses that were told lead to anybody, and those that participants tell.
#include <fmt/format.h>

#include <algorithm>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

std::string text_of(const DdsAddress& address) {
  return address.port == 0 ? address.ip : fmt::format("{}:{}", address.ip, address.port);
}

std::string outcome_of(const AddressProbe& probe) {
  const std::string where = text_of(probe.address);
  if (!probe.fault.empty()) return fmt::format("{}: {}", where, probe.fault);
  if (probe.ports > 0 && probe.refused == probe.ports) {
    return fmt::format("{}: nobody listens there (connection refused)", where);
  }
  return fmt::format("{}: no answer", where);
}

bool is_own(const Observations& seen, const std::string& ip) {
  return std::ranges::any_of(seen.interfaces,
                             [&ip](const Interface& interface) { return interface.ip == ip; });
}

bool is_at(const Observations& seen, const SeenParticipant& peer, const std::string& ip) {
  if (peer.is_of_this_host && is_own(seen, ip)) return true;
  return std::ranges::any_of(peer.locators, [&ip](const SeenLocator& at) { return at.ip == ip; });
}

bool has_answered(const Observations& seen, std::size_t place) {
  const bool by_server = seen.options.discovery == DdsOptions::Discovery::kServer;
  const std::string& ip = seen.addresses[place].address.ip;
  return std::ranges::any_of(seen.as_told.survey.participants, [&](const SeenParticipant& peer) {
    return by_server ? peer.server == place : is_at(seen, peer, ip);
  });
}

std::string firewall_mend(const Observations& seen) {
  const std::uint32_t first = first_port(seen.options);
  return fmt::format(
      "iptables -I INPUT -p udp --dport {}:{} -j ACCEPT    # on both hosts, where a "
      "firewall drops it",
      first, first + kPortsADomain - 1);
}

void check_server(const Observations& seen, std::vector<Finding>& out) {
  for (std::size_t place = 0; place < seen.addresses.size(); ++place) {
    const AddressProbe& probe = seen.addresses[place];
    if (has_answered(seen, place)) {
      out.push_back(
          fine(Concern::kServerUnreachable,
               fmt::format("discovery server {} at {} answers", place, text_of(probe.address))));
      continue;
    }
    std::vector<std::string> mend;
    if (!probe.fault.empty()) mend.push_back(fmt::format("ip route get {}", probe.address.ip));
    mend.push_back(fmt::format("fast-discovery-server -i {} -l {} -p {}    # on that host", place,
                               probe.address.ip, probe.address.port));
    mend.push_back(
        fmt::format("iptables -I INPUT -p udp --dport {} -j ACCEPT    # there, where a "
                    "firewall drops it",
                    probe.address.port));
    out.push_back({Severity::kFault, Concern::kServerUnreachable,
                   fmt::format("discovery server {} at {}", place, outcome_of(probe)),
                   "Who cannot ask a discovery server finds nobody. Servers are numbered from 0 in "
                   "the order of their addresses, which has to be the same for all processes.",
                   std::move(mend)});
  }
}

// Participants that are heard of but whose own addresses cannot be reached.
std::vector<std::string> unreachable_members(const Observations& seen) {
  std::vector<std::string> out;
  for (const SeenParticipant* peer : members_with(seen, Silence::kUnreachable)) {
    std::vector<std::string> ways;
    for (const AddressProbe& probe : seen.silent.at(peer->guid)) ways.push_back(outcome_of(probe));
    out.push_back(fmt::format("{} says to be at {}", name_of(*peer), in_list(ways)));
  }
  return out;
}

void check_peers(const Observations& seen, std::vector<Finding>& out) {
  std::vector<std::string> lost, found, mend;
  for (std::size_t place = 0; place < seen.addresses.size(); ++place) {
    const AddressProbe& probe = seen.addresses[place];
    if (has_answered(seen, place)) {
      found.push_back(text_of(probe.address));
      continue;
    }
    lost.push_back(outcome_of(probe));
    mend.push_back(
        fmt::format("ip route get {}; ping -c 1 {}", probe.address.ip, probe.address.ip));
  }
  for (std::string& text : unreachable_members(seen)) lost.push_back(std::move(text));
  if (lost.empty()) {
    out.push_back(fine(Concern::kPeerUnreachable, found.empty()
                                                      ? "whoever is heard of can be reached"
                                                      : in_list(found) + ": somebody answers"));
    return;
  }
  mend.push_back("--address IP    # where one is wrong, in the settings of all who use it");
  mend.push_back("--interface IP    # there: the address that others reach it at, of several");
  mend.push_back(firewall_mend(seen));
  out.push_back({Severity::kFault, Concern::kPeerUnreachable, in_list(lost),
                 "What is said to such an address is lost, whoever is heard from there.",
                 std::move(mend)});
}

}  // namespace

void check_addresses(const Observations& seen, std::vector<Finding>& out) {
  if (!uses_udp(seen.options) || !seen.as_told.join_fault.empty()) return;
  if (seen.options.discovery == DdsOptions::Discovery::kServer) {
    check_server(seen, out);
  } else {
    check_peers(seen, out);
  }
}

}  // namespace accord
