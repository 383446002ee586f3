#include "coordinator/main/coordinator_metrics.h"

#include <filesystem>
#include <system_error>

namespace accord {
namespace {

using Totals = ServiceTally::Totals;

// What SQLite writes first and folds into the file later included.
double bytes_of_journal(const std::string& path) {
  std::uintmax_t bytes = 0;
  for (const char* suffix : {"", "-wal"}) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path + suffix, error);
    if (!error) bytes += size;
  }
  return static_cast<double>(bytes);
}

void add_journal_metrics(CoordinatorReadings& add, const std::string& journal) {
  const auto writes = [&](const char* outcome, std::uint64_t DeskCounters::*count) {
    add.counter("accord_journal_writes_total", "Writes of the journal, by outcome",
                {{"outcome", outcome}},
                [count](const Totals& t) { return static_cast<double>(t.requests.*count); });
  };
  writes("written", &DeskCounters::writes);
  writes("failed", &DeskCounters::failed_writes);
  add.gauge("accord_journal_takes_writes", "Whether the journal has taken its last write", {},
            [](const Totals& t) { return t.desk.takes_writes ? 1 : 0; });
  add.gauge("accord_journal_bytes", "Size of the journal's files; 0 where there are none", {},
            [journal](const Totals&) { return journal.empty() ? 0 : bytes_of_journal(journal); });
}

void add_health_metrics(CoordinatorReadings& add, const ServiceTally& tally) {
  add.gauge("accord_ready", "Whether /readyz answers 200", {},
            [&tally](const Totals&) { return tally.is_ready() ? 1 : 0; });
  add.gauge("accord_accepting", "Whether requests are accepted; 0: the service is about to end", {},
            [](const Totals& t) { return t.status.accepting ? 1 : 0; });
  add.gauge("accord_loop_turn_age_seconds", "Time since the loop has turned", {},
            [&tally](const Totals&) {
              return std::chrono::duration<double>(tally.since_last_turn()).count();
            });
}

}  // namespace

void add_coordinator_metrics(Metrics& metrics, const ServiceTally& tally,
                             const std::string& journal) {
  CoordinatorReadings add(metrics, [&tally] { return tally.totals(); });
  add_request_metrics(add);
  add_planning_metrics(add);
  add_task_metrics(add);
  add_worker_pool_metrics(add);
  add_message_metrics(add);
  add_journal_metrics(add, journal);
  add_health_metrics(add, tally);
}

}  // namespace accord
