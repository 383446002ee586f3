// Whether somebody is seen of whom nothing comes, and nothing else explains it.
#include <fmt/format.h>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

std::string with_ways(const SeenParticipant& peer) {
  std::vector<std::string> ways;
  for (const SeenLocator& at : peer.locators) {
    if (at.multicast) continue;
    ways.push_back(at.kind == SeenLocator::Kind::kUdp ? fmt::format("{}:{}", at.ip, at.port)
                                                      : fmt::format("fastrtps_port{}", at.port));
  }
  return ways.empty() ? name_of(peer) : fmt::format("{} at {}", name_of(peer), in_list(ways));
}

bool is_reached_over_udp(const Observations& seen, const Peers& peers) {
  if (!seen.by_udp) return false;
  for (const SeenParticipant& other : seen.by_udp->survey.participants) {
    for (const SeenParticipant* peer : peers) {
      if (other.guid == peer->guid && is_reached(other)) return true;
    }
  }
  return false;
}

// A service tells how it stands every two seconds, to whoever it has matched. Whether one has not.
bool check_status(const Observations& seen, std::vector<Finding>& out) {
  if (seen.as_told.survey.service) return false;
  Peers mute = members_with(seen, Silence::kNone);
  std::erase_if(mute, [&seen](const SeenParticipant* peer) {
    return !peer->name || peer->name->role != AccordName::Role::kService ||
           !speaks_our_protocol(seen, *peer->name);
  });
  if (mute.empty()) return false;
  out.push_back({Severity::kFault,
                 Concern::kNoData,
                 fmt::format("has told of its readers and writers, but for {:.1f} s not how it "
                             "stands: {}",
                             seen.listened, names_of(mute)),
                 "A service says so every two seconds: it hangs, or what it sends is lost.",
                 {"curl http://HOST:PORT/healthz    # where it has metrics.port; 503: it hangs",
                  "accord doctor --patience 60    # on bad networks"}});
  return true;
}

}  // namespace

void check_data(const Observations& seen, std::vector<Finding>& out) {
  if (!seen.as_told.join_fault.empty()) return;
  const Peers silent = members_with(seen, Silence::kUnknown);
  const bool is_mute = check_status(seen, out);
  if (silent.empty() && is_mute) return;
  if (silent.empty()) {
    const std::size_t reached = members_with(seen, Silence::kNone).size();
    out.push_back(fine(Concern::kNoData, fmt::format("{} participants of the cluster have told of "
                                                     "their readers and writers",
                                                     reached)));
    return;
  }
  const std::uint32_t first = first_port(seen.options);
  std::vector<std::string> mend{
      fmt::format("iptables -I INPUT -p udp --dport {}:{} -j ACCEPT    # on both hosts, where a "
                  "firewall drops it",
                  first, first + kPortsADomain - 1),
      fmt::format("tcpdump -ni any udp portrange {}-{}    # on both: what leaves, what arrives",
                  first, first + kPortsADomain - 1)};
  if (is_reached_over_udp(seen, silent)) {
    mend.insert(mend.begin(), "ACCORD_DDS_TRANSPORT=udp    # for all of them: that way it answers");
  }
  out.push_back({Severity::kFault, Concern::kNoData,
                 fmt::format("heard of for {:.1f} s, and nothing has come from: {}", seen.listened,
                             names_of(silent, with_ways)),
                 "Its announcements arrive, but it has not told of its readers and writers, which "
                 "goes to each one's own address: most often a firewall lets one pass and not the "
                 "other.",
                 std::move(mend)});
}

}  // namespace accord
