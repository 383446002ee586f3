// News for what watches a service.
#pragma once

#include <string>

#include "common/transport/fleet/fleet_messages.h"

namespace accord::watch_news {

inline RequestState state_of(const std::string& id, RequestPhase phase, double elapsed,
                             std::uint32_t ahead = 0) {
  RequestState state;
  state.id = id;
  state.phase = phase;
  state.elapsed = elapsed;
  state.ahead = ahead;
  return state;
}

inline FinishedPlan ended(const std::string& id, PlanStatus status, double makespan = 0) {
  FinishedPlan out;
  out.id = id;
  out.plan.status = status;
  out.plan.makespan = makespan;
  return out;
}

inline WorkerStatus worker_of(std::uint64_t id, const std::string& standing = "welcome") {
  WorkerStatus worker;
  worker.worker = id;
  worker.host = "box";
  worker.process = static_cast<std::uint32_t>(id);
  worker.threads = 2;
  worker.standing = standing;
  return worker;
}

inline ServiceStatus service_of(std::uint32_t workers, std::uint32_t queued,
                                std::uint32_t planning) {
  ServiceStatus service;
  service.version = "1.2.3";
  service.host = "base";
  service.process = 7;
  service.workers = workers;
  service.queued = queued;
  service.planning = planning;
  return service;
}

}  // namespace accord::watch_news
