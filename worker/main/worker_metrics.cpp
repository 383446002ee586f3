#include "worker/main/worker_metrics.h"

#include <array>
#include <string_view>
#include <utility>

namespace accord {
namespace {

constexpr std::array<std::pair<WorkerTally::Outcome, std::string_view>, WorkerTally::kOutcomes>
    kOutcomes{{{WorkerTally::Outcome::kDone, "done"},
               {WorkerTally::Outcome::kHandedBack, "handed_back"},
               {WorkerTally::Outcome::kRefused, "refused"},
               {WorkerTally::Outcome::kFailed, "failed"}}};

}  // namespace

void add_worker_metrics(Metrics& metrics, const WorkerTally& tally, unsigned threads) {
  for (const auto& [outcome, name] : kOutcomes) {
    auto ended = metrics.counter("accord_worker_tasks_total", "Tasks that ended, by outcome",
                                 {{"outcome", std::string(name)}});
    metrics.before_collection([ended, &tally, outcome = outcome]() mutable {
      ended.raise_to(static_cast<double>(tally.ended(outcome)));
    });
  }
  auto seconds = metrics.counter("accord_worker_solving_seconds_total",
                                 "Time spent on tasks, of all threads together");
  auto employed =
      metrics.gauge("accord_worker_employed", "Whether the worker works for a coordinator");
  metrics.gauge("accord_worker_threads", "Tasks that the worker solves at once").set(threads);
  metrics.before_collection([seconds, employed, &tally]() mutable {
    seconds.raise_to(tally.seconds());
    employed.set(tally.is_employed() ? 1 : 0);
  });
}

}  // namespace accord
