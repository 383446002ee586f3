#include "coordinator/main/coordinator_metrics.h"

#include <array>
#include <functional>
#include <string>
#include <utility>

#include "common/model/plan.h"

namespace accord {
namespace {

using Totals = ServiceTally::Totals;
using Read = std::function<double(const Totals&)>;

constexpr std::array kStatuses{PlanStatus::kSolved, PlanStatus::kInfeasible, PlanStatus::kTimeout,
                               PlanStatus::kCancelled, PlanStatus::kInvalid};

// In the order of Message.
constexpr std::array<const char*, kMessageKinds> kKinds{
    "tasks", "commands", "scenes", "announcements", "results", "heartbeats", "scene_requests"};

class Adder {
 public:
  Adder(Metrics& metrics, const ServiceTally& tally) : metrics_(metrics), tally_(tally) {}

  void counter(const std::string& name, const std::string& help, const Metrics::Labels& labels,
               Read read) {
    auto counter = metrics_.counter(name, help, labels);
    metrics_.before_collection([counter, &tally = tally_, read = std::move(read)]() mutable {
      counter.raise_to(read(tally.totals()));
    });
  }
  void gauge(const std::string& name, const std::string& help, Read read) {
    auto gauge = metrics_.gauge(name, help);
    metrics_.before_collection([gauge, &tally = tally_, read = std::move(read)]() mutable {
      gauge.set(read(tally.totals()));
    });
  }

 private:
  Metrics& metrics_;
  const ServiceTally& tally_;
};

double number(std::uint64_t count) {
  return static_cast<double>(count);
}

void add_requests(Adder& add) {
  const std::string name = "accord_requests_total";
  const std::string help = "Requests by what became of them";
  add.counter(name, help, {{"outcome", "accepted"}},
              [](const Totals& t) { return number(t.requests.accepted); });
  add.counter(name, help, {{"outcome", "rejected"}},
              [](const Totals& t) { return number(t.requests.rejected); });
  add.counter(name, help, {{"outcome", "restored"}},
              [](const Totals& t) { return number(t.requests.restored); });
  for (const PlanStatus status : kStatuses) {
    add.counter("accord_plans_total", "Requests that are finished, by the status of their plans",
                {{"status", std::string(to_string(status))}}, [status](const Totals& t) {
                  const auto found = t.requests.finished.find(status);
                  return found == t.requests.finished.end() ? 0.0 : number(found->second);
                });
  }
  add.gauge("accord_requests_queued", "Accepted requests whose planning has not begun",
            [](const Totals& t) { return number(t.status.queued); });
  add.gauge("accord_requests_planning", "Requests that are being planned",
            [](const Totals& t) { return number(t.status.planning); });
}

void add_tasks(Adder& add) {
  const std::string name = "accord_tasks_total";
  const std::string help = "Tasks given to workers, by what became of them";
  const auto event = [&](const char* label, std::uint64_t TaskBoard::Counters::*count) {
    add.counter(name, help, {{"event", label}},
                [count](const Totals& t) { return number(t.tasks.*count); });
  };
  event("assigned", &TaskBoard::Counters::assigned);
  event("finished", &TaskBoard::Counters::finished);
  event("late", &TaskBoard::Counters::late);
  event("reassigned", &TaskBoard::Counters::reassigned);
  event("quarantined", &TaskBoard::Counters::quarantined);
  add.gauge("accord_tasks_unfinished", "Tasks that wait or are at a worker",
            [](const Totals& t) { return number(t.unfinished_tasks); });
  add.gauge("accord_workers", "Workers that take tasks",
            [](const Totals& t) { return number(t.status.workers); });
  add.gauge("accord_worker_threads", "Tasks that the workers solve at once, together",
            [](const Totals& t) { return number(t.status.threads); });
  add.counter("accord_workers_lost_total", "Workers that died or fell silent", {},
              [](const Totals& t) { return number(t.tasks.workers_lost); });
  add.counter("accord_workers_refused_total", "Workers of another protocol", {},
              [](const Totals& t) { return number(t.tasks.workers_refused); });
}

void add_messages(Adder& add) {
  for (std::size_t kind = 0; kind < kMessageKinds; ++kind) {
    const auto way = [&](const char* direction, std::uint64_t BusCounters::Kind::*messages,
                         std::uint64_t BusCounters::Kind::*bytes) {
      const Metrics::Labels labels{{"topic", kKinds[kind]}, {"direction", direction}};
      add.counter("accord_messages_total", "Messages to and from workers, by topic", labels,
                  [=](const Totals& t) { return number(t.bus.kinds[kind].*messages); });
      add.counter("accord_message_bytes_total", "Their bytes, about", labels,
                  [=](const Totals& t) { return number(t.bus.kinds[kind].*bytes); });
    };
    way("sent", &BusCounters::Kind::sent, &BusCounters::Kind::sent_bytes);
    way("received", &BusCounters::Kind::received, &BusCounters::Kind::received_bytes);
  }
  add.counter("accord_messages_dropped_total", "Messages that were beyond a limit or not for us",
              {}, [](const Totals& t) {
                return number(t.bus.malformed + t.bus.foreign + t.bus.early + t.fleet.malformed);
              });
}

}  // namespace

void add_coordinator_metrics(Metrics& metrics, const ServiceTally& tally) {
  Adder add(metrics, tally);
  add_requests(add);
  add_tasks(add);
  add_messages(add);
}

}  // namespace accord
