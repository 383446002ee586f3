#include "client/doctor/diagnosis.h"

#include <algorithm>
#include <tuple>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {

std::vector<Finding> diagnose(const Observations& seen) {
  std::vector<Finding> out;
  for (const auto check :
       {check_domain, check_shared_memory, check_shared_ports, check_socket_buffers,
        check_multicast, check_addresses, check_transport, check_security, check_protocol,
        check_cluster, check_data, check_clocks, check_service}) {
    check(seen, out);
  }
  std::ranges::stable_sort(out, [](const Finding& a, const Finding& b) {
    return std::tuple(b.severity, a.concern) < std::tuple(a.severity, b.concern);
  });
  return out;
}

bool is_settled(const DdsOptions& options, const DomainSurvey& survey) {
  if (!survey.service) return false;
  bool has_two_words = false;
  for (const SeenParticipant& peer : survey.participants) {
    if (!peer.name || peer.name->cluster != options.cluster) continue;
    if (peer.name->role == AccordName::Role::kClient) continue;
    if (!is_reached(peer)) return false;
    has_two_words |= peer.name->role == AccordName::Role::kService && peer.clock_ahead.has_value();
  }
  return has_two_words;
}

}  // namespace accord
