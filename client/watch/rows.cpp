#include "client/watch/rows.h"

#include <limits>

#include "common/transport/endpoint_id.h"

namespace accord {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Row row_of(const WatchedRequest& request, WatchTime now) {
  const RequestState& state = request.state;
  static const WatchedRequest::Outcome kNone;
  const bool has_ended = request.is_finished() && request.outcome;
  const WatchedRequest::Outcome& outcome = has_ended ? *request.outcome : kNone;
  const bool is_solved = has_ended && outcome.status == PlanStatus::kSolved;
  // Those in tables leave an id its place among 80 columns.
  return {
      {"id", "request", state.id},
      {"phase", "phase", std::string(to_string(state.phase))},
      {"ahead", "", std::uint64_t{state.ahead}},
      {"robots", "", std::uint64_t{state.robots}},
      {"robots_planned", "", std::uint64_t{state.robots_planned}},
      {"conflicts_found", "found", state.conflicts_found},
      {"conflicts_resolved", "resolved", state.conflicts_resolved},
      {"rounds", "round", state.rounds},
      {"elapsed", "elapsed", Seconds{request.elapsed(now)}},
      {"outcome", "outcome", has_ended ? std::string(to_string(outcome.status)) : ""},
      {"makespan", "", Seconds{is_solved ? outcome.makespan : kUnknown}},
      {"message", "", outcome.message},
  };
}

Row row_of(const WatchedWorker& worker) {
  const WorkerStatus& status = worker.status;
  return {
      {"worker", "worker", to_string(EndpointId{status.worker})},
      {"host", "host", status.host},
      {"process", "process", std::uint64_t{status.process}},
      {"version", "version", status.version},
      {"threads", "threads", std::uint64_t{status.threads}},
      {"busy", "busy", std::uint64_t{status.busy}},
      {"standing", "standing", status.standing},
      {"text", "why", status.text},
  };
}

Row row_of(const WatchedService& service, WatchTime now) {
  const ServiceStatus& status = service.status;
  // Those in tables fit into 80 columns.
  return {
      {"present", "", service.is_present},
      {"host", "host", status.host},
      {"process", "", std::uint64_t{status.process}},
      {"version", "version", status.version},
      {"uptime", "uptime", Seconds{service.uptime(now)}},
      {"workers", "workers", std::uint64_t{status.workers}},
      {"threads", "", std::uint64_t{status.threads}},
      {"queued", "queued", std::uint64_t{status.queued}},
      {"planning", "planning", std::uint64_t{status.planning}},
      {"finished", "finished", status.finished},
      {"accepting", "accepting", status.accepting},
  };
}

NamedRow row_of(const WatchedFleet::Change& change, WatchTime now) {
  if (const auto* request = std::get_if<WatchedRequest>(&change)) {
    return {"request", row_of(*request, now)};
  }
  if (const auto* worker = std::get_if<WatchedWorker>(&change)) return {"worker", row_of(*worker)};
  return {"service", row_of(std::get<WatchedService>(change), now)};
}

}  // namespace accord
