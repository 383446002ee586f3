// Whether somebody of the cluster is there, but not for who has been told what this process has.
#include <fmt/format.h>

#include <algorithm>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

Peers only_in(const Observations& seen, const std::optional<Look>& look) {
  if (!look) return {};
  const auto& known = seen.as_told.survey.participants;
  Peers out = members(seen, look->survey);
  std::erase_if(out, [&known](const SeenParticipant* peer) {
    return std::ranges::any_of(
        known, [&](const SeenParticipant& other) { return other.guid == peer->guid; });
  });
  return out;
}

std::string with_address(const SeenParticipant& peer) {
  for (const SeenLocator& at : peer.locators) {
    if (at.kind == SeenLocator::Kind::kUdp && !at.multicast) {
      return fmt::format("{} ({}{})", name_of(peer), at.ip,
                         peer.is_of_this_host ? ", this machine" : "");
    }
  }
  return name_of(peer);
}

const char* name_of(DdsOptions::Discovery discovery) {
  switch (discovery) {
    case DdsOptions::Discovery::kMulticast:
      return "multicast";
    case DdsOptions::Discovery::kPeers:
      return "peers";
    case DdsOptions::Discovery::kServer:
      break;
  }
  return "server";
}

Finding of_udp(const Observations& seen, const Peers& hidden) {
  const DdsOptions& told = seen.options;
  Finding out{Severity::kFault,
              Concern::kTransport,
              fmt::format("there over UDP by multicast, but not for these settings: {}",
                          names_of(hidden, with_address)),
              "Processes work together that have a way in common: a transport, a network, and a "
              "way to find each other.",
              {}};
  if (told.transport == DdsOptions::Transport::kSharedMemory) {
    out.mend.emplace_back("--transport both    # here");
  }
  if (!told.interfaces.empty()) {
    out.seen += fmt::format("; these are kept to {}", in_list(told.interfaces));
    out.mend.emplace_back(
        "unset ACCORD_DDS_INTERFACES    # or --interface with an address of their "
        "network");
  }
  if (told.discovery != DdsOptions::Discovery::kMulticast) {
    out.seen += fmt::format("; these use --discovery {}", name_of(told.discovery));
    out.mend.push_back(
        fmt::format("--discovery {}    # there, with the same addresses; or "
                    "--discovery multicast here",
                    name_of(told.discovery)));
  }
  if (out.mend.empty()) out.mend.emplace_back("accord doctor --transport udp");
  return out;
}

Finding of_memory(const Peers& hidden) {
  return {
      Severity::kFault,
      Concern::kTransport,
      fmt::format("there by shared memory alone, and not over UDP: {}", names_of(hidden)),
      "Who has shared memory alone (--transport shm) is found by nobody but by others that have "
      "it alone; who has both looks for others over UDP.",
      {"ACCORD_DDS_TRANSPORT=both    # for it, or shm for all processes; all on this machine"}};
}

}  // namespace

void check_transport(const Observations& seen, std::vector<Finding>& out) {
  if (!seen.as_told.join_fault.empty() || is_shut_out_of_memory(seen)) return;
  Peers by_udp = only_in(seen, seen.by_udp);
  for (const SeenParticipant* peer : members_with(seen, Silence::kOtherNetwork)) {
    by_udp.push_back(peer);
  }
  const Peers by_memory = only_in(seen, seen.by_memory);
  if (!by_udp.empty()) out.push_back(of_udp(seen, by_udp));
  if (!by_memory.empty()) out.push_back(of_memory(by_memory));
  if (by_udp.empty() && by_memory.empty()) {
    out.push_back(fine(Concern::kTransport, "nobody of the cluster is there by other ways alone"));
  }
}

}  // namespace accord
