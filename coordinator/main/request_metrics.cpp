// What /metrics says of requests and of their planning.
#include <array>
#include <map>

#include "common/planning/method_names.h"
#include "coordinator/main/coordinator_metrics.h"

namespace accord {
namespace {

using Totals = ServiceTally::Totals;

constexpr std::array kStatuses{PlanStatus::kSolved, PlanStatus::kInfeasible, PlanStatus::kTimeout,
                               PlanStatus::kCancelled, PlanStatus::kInvalid};
constexpr std::array kRejections{
    Rejection::kBadId,        Rejection::kIdInUse,       Rejection::kBadScene,
    Rejection::kUnknownScene, Rejection::kBadQuery,      Rejection::kBadOption,
    Rejection::kTooLarge,     Rejection::kQueueFull,     Rejection::kNoJournal,
    Rejection::kShuttingDown, Rejection::kUnknownRequest};

template <typename Number>
double number(Number count) {
  return static_cast<double>(count);
}

template <typename Key, typename Value>
Value value_of(const std::map<Key, Value>& counts, const Key& key) {
  const auto found = counts.find(key);
  return found == counts.end() ? Value{} : found->second;
}

}  // namespace

void add_request_metrics(CoordinatorReadings& add) {
  const auto in_hand = [&](const char* state, std::size_t RequestDesk::Load::*count) {
    add.gauge("accord_requests", "Requests in hand, by state", {{"state", state}},
              [count](const Totals& t) { return number(t.desk.*count); });
  };
  in_hand("reading", &RequestDesk::Load::reading);
  in_hand("queued", &RequestDesk::Load::queued);
  in_hand("planning", &RequestDesk::Load::planning);
  in_hand("unwritten", &RequestDesk::Load::unwritten);
  add.gauge("accord_requests_oldest_queued_seconds",
            "Age of the oldest request whose planning has not begun", {},
            [](const Totals& t) { return std::chrono::duration<double>(t.desk.oldest).count(); });
  add.gauge("accord_requests_held_bytes", "Bytes that the requests in hand have brought", {},
            [](const Totals& t) { return number(t.desk.bytes); });
  add.gauge("accord_plans_kept", "Finished plans in the journal", {},
            [](const Totals& t) { return number(t.desk.kept); });
  add.counter("accord_requests_accepted_total", "Requests that were accepted", {},
              [](const Totals& t) { return number(t.requests.accepted); });
  add.counter("accord_requests_restored_total",
              "Unfinished requests that were found in the journal", {},
              [](const Totals& t) { return number(t.requests.restored); });
  for (const Rejection reason : kRejections) {
    add.counter("accord_requests_rejected_total", "Requests that were rejected, by reason",
                {{"reason", std::string(to_string(reason))}}, [reason](const Totals& t) {
                  return number(value_of(t.requests.rejected, reason));
                });
  }
  add.histogram("accord_request_queue_seconds",
                "Time from a request's acceptance until its planning is begun", {},
                [](const Totals& t) { return t.requests.queued; });
  for (const PlanStatus status : kStatuses) {
    const Metrics::Labels labels{{"status", std::string(to_string(status))}};
    add.counter(
        "accord_requests_finished_total",
        "Requests that are finished, by the status of their plans", labels,
        [status](const Totals& t) { return number(value_of(t.requests.finished, status)); });
    add.histogram("accord_request_planning_seconds",
                  "Time that planning a request took, proof included, by its plan's status", labels,
                  [status](const Totals& t) { return value_of(t.requests.planning, status); });
  }
  add.histogram("accord_request_proof_seconds", "Time that proving a plan took", {},
                [](const Totals& t) { return t.requests.proof; });
}

void add_planning_metrics(CoordinatorReadings& add) {
  add.counter("accord_conflicts_found_total", "Conflicts between robots' paths that were found", {},
              [](const Totals& t) { return number(t.requests.conflicts_found); });
  add.counter("accord_conflicts_resolved_total",
              "Resolutions that were committed; one may end many conflicts", {},
              [](const Totals& t) { return number(t.requests.conflicts_resolved); });
  add.counter("accord_rounds_total", "Rounds of subproblems that share no robots", {},
              [](const Totals& t) { return number(t.requests.rounds); });
  const auto subproblems = [&](const char* outcome, CoordinatorReadings::Read<double> read) {
    add.counter("accord_subproblems_total", "Subproblems of finished planning, by outcome",
                {{"outcome", outcome}}, std::move(read));
  };
  subproblems("committed", [](const Totals& t) {
    double all = 0;
    for (const auto& [solver, count] : t.requests.resolutions) all += number(count);
    return all;
  });
  subproblems("exhausted",
              [](const Totals& t) { return number(t.requests.subproblems_exhausted); });
  subproblems("set_aside",
              [](const Totals& t) { return number(t.requests.subproblems_set_aside); });
  std::vector<std::string> solvers = resolution_solver_names();
  solvers.emplace_back(kOtherSolver);
  for (const std::string& solver : solvers) {
    add.counter("accord_resolutions_total",
                "Subproblems of finished planning whose resolution was committed, by solver",
                {{"solver", solver}}, [solver](const Totals& t) {
                  return number(value_of(t.requests.resolutions, solver));
                });
    for (std::size_t i = 0; i < kLevelOutcomes; ++i) {
      const std::string outcome(to_string(static_cast<LevelOutcome>(i)));
      add.counter("accord_attempts_total",
                  "Attempts at subproblems, ahead of need included, by solver and outcome",
                  {{"solver", solver}, {"outcome", outcome}}, [solver, i](const Totals& t) {
                    return number(value_of(t.attempts, solver).at(i));
                  });
    }
  }
}

}  // namespace accord
