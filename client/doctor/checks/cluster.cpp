// Whether those who are there are of this cluster.
#include <fmt/format.h>

#include <map>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {

void check_cluster(const Observations& seen, std::vector<Finding>& out) {
  if (!seen.as_told.join_fault.empty()) return;
  std::map<std::string, std::size_t> clusters;
  for (const SeenParticipant& peer : seen.as_told.survey.participants) {
    if (peer.name && peer.name->role != AccordName::Role::kClient) ++clusters[peer.name->cluster];
  }
  const std::size_t ours = clusters[seen.options.cluster];
  clusters.erase(seen.options.cluster);
  std::vector<std::string> others, mend;
  for (const auto& [cluster, count] : clusters) {
    others.push_back(fmt::format("\"{}\" ({})", cluster, count));
    if (mend.size() < 3) mend.push_back("--cluster " + cluster);
  }
  if (ours > 0 || others.empty()) {
    out.push_back(fine(Concern::kCluster,
                       fmt::format("{} participants of \"{}\"{}", ours, seen.options.cluster,
                                   others.empty() ? "" : "; also " + in_list(others))));
    return;
  }
  out.push_back({Severity::kFault, Concern::kCluster,
                 fmt::format("nobody of \"{}\", but participants of {}", seen.options.cluster,
                             in_list(others)),
                 "Only processes of one cluster work together.", std::move(mend)});
}

}  // namespace accord
