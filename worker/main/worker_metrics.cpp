#include "worker/main/worker_metrics.h"

#include <array>
#include <string>
#include <utility>

#include "common/planning/method_names.h"
#include "common/runtime/metric_readings.h"
#include "common/transport/bus_metrics.h"

namespace accord {
namespace {

using Totals = WorkerTally::Totals;
using Readings = MetricReadings<Totals>;

constexpr std::array<std::pair<WorkerTally::Outcome, const char*>, WorkerTally::kOutcomes>
    kOutcomes{{{WorkerTally::Outcome::kDone, "done"},
               {WorkerTally::Outcome::kHandedBack, "handed_back"},
               {WorkerTally::Outcome::kRefused, "refused"},
               {WorkerTally::Outcome::kFailed, "failed"}}};

void add_tasks(Readings& add) {
  for (const auto& [outcome, label] : kOutcomes) {
    add.counter("accord_worker_tasks_total", "Tasks that ended, by outcome", {{"outcome", label}},
                [i = static_cast<std::size_t>(outcome)](const Totals& t) {
                  return static_cast<double>(t.ended.at(i));
                });
  }
  add.gauge("accord_worker_tasks_waiting", "Tasks that the worker has and has not begun", {},
            [](const Totals& t) { return static_cast<double>(t.load.waiting); });
}

void add_solvers(Readings& add) {
  std::vector<std::string> solvers = resolution_solver_names();
  solvers.emplace_back(kOtherSolver);
  for (const std::string& solver : solvers) {
    add.histogram("accord_worker_task_seconds",
                  "Time that solving a task took, by the last solver that was tried",
                  {{"solver", solver}}, [solver](const Totals& t) {
                    const auto found = t.solving.find(solver);
                    return found == t.solving.end() ? TimeHistogram{} : found->second;
                  });
    for (std::size_t i = 0; i < kLevelOutcomes; ++i) {
      const std::string outcome(to_string(static_cast<LevelOutcome>(i)));
      add.counter("accord_worker_attempts_total",
                  "Solvers that were tried on tasks, by solver and outcome",
                  {{"solver", solver}, {"outcome", outcome}}, [solver, i](const Totals& t) {
                    const auto found = t.attempts.find(solver);
                    return found == t.attempts.end() ? 0 : static_cast<double>(found->second.at(i));
                  });
    }
  }
}

void add_threads(Readings& add, unsigned threads) {
  add.gauge("accord_worker_threads", "Tasks that the worker solves at once", {},
            [threads](const Totals&) { return threads; });
  add.gauge("accord_worker_busy_threads", "Tasks that the worker solves just now", {},
            [](const Totals& t) { return static_cast<double>(t.load.running); });
  add.counter("accord_worker_busy_seconds_total", "Time spent on tasks, of all threads together",
              {}, [](const Totals& t) { return t.busy_seconds; });
}

void add_health(Readings& add, const WorkerTally& tally) {
  add.gauge("accord_worker_employed", "Whether the worker works for a coordinator", {},
            [](const Totals& t) { return t.load.is_employed ? 1 : 0; });
  add.gauge("accord_ready", "Whether /readyz answers 200", {},
            [&tally](const Totals&) { return tally.is_ready() ? 1 : 0; });
  add.gauge("accord_loop_turn_age_seconds", "Time since the loop has turned", {},
            [&tally](const Totals&) {
              return std::chrono::duration<double>(tally.since_last_turn()).count();
            });
}

}  // namespace

void add_worker_metrics(Metrics& metrics, const WorkerTally& tally, unsigned threads) {
  Readings add(metrics, [&tally] { return tally.totals(); });
  add_tasks(add);
  add_solvers(add);
  add_threads(add, threads);
  add_bus_metrics<Totals>(add, [](const Totals& t) { return t.load.bus; });
  add_health(add, tally);
}

}  // namespace accord
