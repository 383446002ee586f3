// Whether all speak one protocol, and are of one version.
#include <fmt/format.h>

#include <set>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

std::string with_protocol(const SeenParticipant& peer) {
  return fmt::format("{} speaks {}", name_of(peer), peer.name ? peer.name->protocol : 0);
}

// Programs of other versions than this one, as they say themselves.
std::vector<std::string> other_versions(const Observations& seen) {
  std::set<std::string> out;
  const DomainSurvey& survey = seen.as_told.survey;
  if (survey.service && survey.service->version != seen.version) {
    out.insert(
        fmt::format("the coordinator on {} is {}", survey.service->host, survey.service->version));
  }
  for (const WorkerStatus& worker : survey.workers) {
    if (worker.version == seen.version || worker.standing == "lost") continue;
    out.insert(
        fmt::format("worker {:016x} on {} is {}", worker.worker, worker.host, worker.version));
  }
  return {out.begin(), out.end()};
}

}  // namespace

void check_protocol(const Observations& seen, std::vector<Finding>& out) {
  if (!seen.as_told.join_fault.empty()) return;
  Peers foreign = members(seen, seen.as_told.survey);
  std::erase_if(foreign, [&seen](const SeenParticipant* peer) {
    return !peer->name || speaks_our_protocol(seen, *peer->name);
  });
  if (!foreign.empty()) {
    out.push_back(
        {Severity::kFault,
         Concern::kOtherProtocol,
         fmt::format("another protocol than {}: {}", seen.options.protocol,
                     names_of(foreign, with_protocol)),
         "Processes of different protocols use different topics, and pass each other by.",
         {fmt::format("accord-worker --version    # install {} on every host", seen.version)}});
    return;
  }
  const auto others = other_versions(seen);
  if (others.empty()) {
    out.push_back(fine(Concern::kOtherProtocol,
                       fmt::format("nobody speaks another one than {}", seen.options.protocol)));
    return;
  }
  out.push_back(
      {Severity::kWarning,
       Concern::kOtherProtocol,
       fmt::format("this is {}; {}", seen.version, in_list(others)),
       "Different versions work together until one uses what another does not know; such "
       "a task is refused and given to others.",
       {fmt::format("accord-worker --version    # install {} on every host", seen.version)}});
}

}  // namespace accord
