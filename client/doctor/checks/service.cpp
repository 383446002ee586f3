// Whether a service answers, and counts the workers that are there.
#include <fmt/format.h>

#include <algorithm>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

constexpr const char* kStartService = "accord-coordinator --journal accord.db";

std::string flags_of(const DdsOptions& options) {
  std::string out;
  if (options.domain != 0) out += fmt::format(" --domain {}", options.domain);
  if (options.cluster != "default") out += " --cluster " + options.cluster;
  return out;
}

std::string domains_of(const Observations& seen) {
  std::vector<std::string> others;
  for (const std::uint32_t domain : seen.domains_here) {
    if (domain != seen.options.domain) others.push_back(std::to_string(domain));
  }
  return others.empty() ? "" : "; DDS of this machine is also in domain " + in_list(others);
}

const WorkerStatus* status_of(const DomainSurvey& survey, std::uint64_t worker) {
  const auto found = std::ranges::find(survey.workers, worker, &WorkerStatus::worker);
  return found == survey.workers.end() ? nullptr : &*found;
}

// Workers that are heard here, and that the service does not give work to.
std::vector<std::string> idle_workers(const Observations& seen) {
  const DomainSurvey& survey = seen.as_told.survey;
  std::vector<std::string> out;
  for (const SeenParticipant* peer : members_with(seen, Silence::kNone)) {
    if (!peer->name || peer->name->role != AccordName::Role::kWorker) continue;
    if (!speaks_our_protocol(seen, *peer->name)) continue;
    const WorkerStatus* status = status_of(survey, peer->name->id);
    if (status == nullptr || status->standing == "lost") {
      out.push_back(name_of(*peer) + " is unknown to it");
    } else if (status->standing != "welcome" && status->standing != "leaving") {
      out.push_back(fmt::format("{} on {} is {}: {}", name_of(*peer), status->host,
                                status->standing, status->text));
    }
  }
  return out;
}

void check_workers(const Observations& seen, const ServiceStatus& service,
                   std::vector<Finding>& out) {
  const auto idle = idle_workers(seen);
  if (service.workers > 0 && idle.empty()) {
    out.push_back(fine(Concern::kWorkers, fmt::format("{} work for the service, {} threads",
                                                      service.workers, service.threads)));
    return;
  }
  std::string text = fmt::format("{} work for the service", service.workers);
  if (!idle.empty()) text += "; but " + in_list(idle);
  const bool is_idle = service.workers == 0;
  std::vector<std::string> mend;
  if (idle.empty()) mend.push_back("accord-worker" + flags_of(seen.options));
  if (!idle.empty())
    mend.emplace_back("accord doctor    # where that worker runs, with its settings");
  out.push_back({Severity::kFault, Concern::kWorkers, std::move(text),
                 is_idle ? "Without workers, requests are accepted and wait."
                         : "The service plans, but not with all who are there.",
                 std::move(mend)});
}

}  // namespace

void check_service(const Observations& seen, std::vector<Finding>& out) {
  if (!seen.as_told.join_fault.empty()) return;
  const auto& service = seen.as_told.survey.service;
  if (service) {
    out.push_back(fine(
        Concern::kService,
        fmt::format("{} on {} (process {}) answers; {} queued, {} planning{}", service->version,
                    service->host, service->process, service->queued, service->planning,
                    service->accepting ? "" : "; it drains, and accepts no more")));
    check_workers(seen, *service, out);
    return;
  }
  const std::size_t members_seen = members(seen, seen.as_told.survey).size();
  out.push_back(
      {Severity::kWarning,
       Concern::kService,
       members_seen == 0
           ? fmt::format("nobody of Accord's is in domain {}, cluster \"{}\", as far as {:.1f} s "
                         "tell{}",
                         seen.options.domain, seen.options.cluster, seen.listened, domains_of(seen))
           : fmt::format("none has answered within {:.1f} s", seen.listened),
       "Requests are taken by a coordinator in the same domain and cluster.",
       {kStartService + flags_of(seen.options),
        "accord doctor --domain N    # where it runs in another; --patience 60 on bad networks"}});
}

}  // namespace accord
