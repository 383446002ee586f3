// What /metrics says of tasks, of workers as the coordinator knows them, and of messages.
#include <array>
#include <string>
#include <utility>

#include "common/transport/bus_metrics.h"
#include "coordinator/main/coordinator_metrics.h"

namespace accord {
namespace {

using Totals = ServiceTally::Totals;
using Standing = WorkerRecord::Standing;

constexpr std::array<std::pair<Reassigned, const char*>, kReassignedKinds> kReasons{
    {{Reassigned::kWorkerLost, "worker_lost"},
     {Reassigned::kUnheard, "unheard"},
     {Reassigned::kHandedBack, "handed_back"},
     {Reassigned::kFailed, "failed"},
     {Reassigned::kRefused, "refused"},
     {Reassigned::kDistrusted, "distrusted"}}};
constexpr std::array<std::pair<Standing, const char*>, 4> kStandings{
    {{Standing::kWelcome, "welcome"},
     {Standing::kLeaving, "leaving"},
     {Standing::kDistrusted, "distrusted"},
     {Standing::kRefused, "refused"}}};

template <typename Number>
double number(Number count) {
  return static_cast<double>(count);
}

void count(CoordinatorReadings& add, const char* name, const char* help,
           const Metrics::Labels& labels, std::uint64_t BoardCounters::*total) {
  add.counter(name, help, labels, [total](const Totals& t) { return number(t.tasks.*total); });
}

void count_seconds(CoordinatorReadings& add, const char* name, const char* help,
                   double BoardCounters::*total) {
  add.counter(name, help, {}, [total](const Totals& t) { return t.tasks.*total; });
}

void gauge(CoordinatorReadings& add, const char* name, const char* help,
           const Metrics::Labels& labels, std::size_t TaskBoard::Load::*load) {
  add.gauge(name, help, labels, [load](const Totals& t) { return number(t.board.*load); });
}

}  // namespace

void add_task_metrics(CoordinatorReadings& add) {
  const char* tasks = "Tasks in hand, by state";
  gauge(add, "accord_tasks", tasks, {{"state", "waiting"}}, &TaskBoard::Load::waiting);
  gauge(add, "accord_tasks", tasks, {{"state", "assigned"}}, &TaskBoard::Load::assigned);
  add.gauge("accord_tasks_oldest_waiting_seconds",
            "Time that the task waits which has waited longest, of those that are needed", {},
            [](const Totals& t) { return std::chrono::duration<double>(t.board.oldest).count(); });
  count(add, "accord_tasks_added_total", "Tasks that planning has asked for", {},
        &BoardCounters::added);
  count(add, "accord_tasks_assigned_total", "Tasks given to workers, each time anew", {},
        &BoardCounters::assigned);
  const auto ended = [&](const char* outcome, std::uint64_t BoardCounters::*total) {
    count(add, "accord_tasks_ended_total", "Tasks that have ended, by outcome",
          {{"outcome", outcome}}, total);
  };
  ended("done", &BoardCounters::done);
  ended("cancelled", &BoardCounters::cancelled);
  ended("refused", &BoardCounters::refused);
  ended("quarantined", &BoardCounters::quarantined);
  for (const auto& [reason, label] : kReasons) {
    add.counter("accord_tasks_reassigned_total",
                "Tasks that were taken from a worker and given out anew, by reason",
                {{"reason", label}}, [i = static_cast<std::size_t>(reason)](const Totals& t) {
                  return number(t.tasks.reassigned_for.at(i));
                });
  }
  count(add, "accord_tasks_put_off_total", "Tasks ahead of need that made way for needed ones", {},
        &BoardCounters::put_off);
  const auto dropped = [&](const char* reason, std::uint64_t BoardCounters::*total) {
    count(add, "accord_results_dropped_total", "Results that no task waited for, by reason",
          {{"reason", reason}}, total);
  };
  dropped("late", &BoardCounters::late);
  dropped("duplicate", &BoardCounters::duplicate);
  dropped("moot", &BoardCounters::moot);
  add.histogram("accord_task_wait_seconds",
                "Time that a task has waited when it is given to a worker", {},
                [](const Totals& t) { return t.tasks.waited; });
  count_seconds(add, "accord_task_solving_seconds_total",
                "Time that workers spent on the tasks that are done",
                &BoardCounters::solving_seconds);
}

void add_worker_pool_metrics(CoordinatorReadings& add) {
  for (const auto& [standing, label] : kStandings) {
    add.gauge("accord_workers", "Workers, by standing", {{"standing", label}},
              [standing = standing](const Totals& t) {
                const auto found = t.board.workers.find(standing);
                return found == t.board.workers.end() ? 0 : number(found->second);
              });
  }
  const char* lost = "Workers that were lost, by how";
  count(add, "accord_workers_lost_total", lost, {{"reason", "gone"}}, &BoardCounters::workers_gone);
  count(add, "accord_workers_lost_total", lost, {{"reason", "silent"}},
        &BoardCounters::workers_silent);
  count(add, "accord_workers_left_total", "Workers that left in order", {},
        &BoardCounters::workers_left);
  count(add, "accord_workers_refused_total", "Workers of another protocol", {},
        &BoardCounters::workers_refused);
  count(add, "accord_workers_distrusted_total", "Workers that gave a result which does not hold",
        {}, &BoardCounters::workers_distrusted);
  gauge(add, "accord_cluster_threads", "Tasks that the workers solve at once, together", {},
        &TaskBoard::Load::threads);
  gauge(add, "accord_cluster_busy_threads", "Of these, threads at work, as workers say", {},
        &TaskBoard::Load::busy);
  count_seconds(add, "accord_cluster_thread_seconds_total",
                "Time of the workers' threads, all of them, as heartbeats tell",
                &BoardCounters::thread_seconds);
  count_seconds(add, "accord_cluster_busy_seconds_total",
                "Time of the workers' threads that were at work, as heartbeats tell",
                &BoardCounters::busy_seconds);
}

void add_message_metrics(CoordinatorReadings& add) {
  add_bus_metrics<Totals>(add, [](const Totals& t) { return t.bus; });
  for (std::size_t topic = 0; topic < kFleetTopics; ++topic) {
    add_traffic_metrics<Totals>(add, "fleet", std::string(kFleetTopicNames.at(topic)),
                                [topic](const Totals& t) { return t.fleet.topics.at(topic); });
  }
  const auto dropped = [&](const char* reason, std::uint64_t FleetCounters::*total) {
    add.counter("accord_messages_dropped_total", kMessagesDroppedHelp,
                {{"bus", "fleet"}, {"reason", reason}},
                [total](const Totals& t) { return number(t.fleet.*total); });
  };
  dropped("malformed", &FleetCounters::malformed);
  dropped("unsent", &FleetCounters::unsent);
}

}  // namespace accord
