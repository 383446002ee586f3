// What /metrics and /readyz say of a coordinator.
#include "coordinator/main/coordinator_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

using ::testing::HasSubstr;

ServiceTally::Totals at_work() {
  ServiceTally::Totals totals;
  totals.board.threads = 4;
  return totals;
}

TEST(CoordinatorMetrics, FollowTheTally) {
  const testing::ScratchFolder folder;
  const std::string journal = (folder.path() / "journal.db").string();
  std::ofstream(journal) << "12345";
  std::ofstream(journal + "-wal") << "678";
  ServiceTally tally;
  Metrics metrics;
  add_coordinator_metrics(metrics, tally, journal);
  EXPECT_THAT(metrics.collect(), HasSubstr("accord_ready 0\n")) << "it has not begun";

  ServiceTally::Totals totals = at_work();
  totals.requests.rejected[Rejection::kQueueFull] = 2;
  totals.requests.planning[PlanStatus::kSolved].add(3);
  totals.requests.resolutions["prioritized-query"] = 4;
  totals.attempts["decoupled-prm"][static_cast<std::size_t>(LevelOutcome::kExhausted)] = 5;
  totals.tasks.reassigned_since(Reassigned::kUnheard) = 6;
  totals.tasks.moot = 7;
  totals.board.workers[WorkerRecord::Standing::kLeaving] = 1;
  totals.fleet.topics.at(fleet_topic_index("robot_plans")).sent_bytes = 8;
  totals.desk.queued = 9;
  totals.desk.oldest = std::chrono::milliseconds(1500);
  tally.note(totals);
  const std::string text = metrics.collect();
  for (const char* line :
       {"accord_requests_rejected_total{reason=\"queue_full\"} 2\n",
        "accord_requests_rejected_total{reason=\"bad_id\"} 0\n",
        "accord_request_planning_seconds_sum{status=\"solved\"} 3\n",
        "accord_request_planning_seconds_count{status=\"timeout\"} 0\n",
        "accord_resolutions_total{solver=\"prioritized-query\"} 4\n",
        "accord_subproblems_total{outcome=\"committed\"} 4\n",
        "accord_attempts_total{outcome=\"exhausted\",solver=\"decoupled-prm\"} 5\n",
        "accord_tasks_reassigned_total{reason=\"unheard\"} 6\n",
        "accord_results_dropped_total{reason=\"moot\"} 7\n",
        "accord_workers{standing=\"leaving\"} 1\n", "accord_workers{standing=\"refused\"} 0\n",
        "accord_message_bytes_total{bus=\"fleet\",direction=\"sent\",topic=\"robot_plans\"} 8\n",
        "accord_messages_total{bus=\"workers\",direction=\"received\",topic=\"results\"} 0\n",
        "accord_requests{state=\"queued\"} 9\n", "accord_requests_oldest_queued_seconds 1.5\n",
        "accord_cluster_threads 4\n", "accord_journal_bytes 8\n", "accord_ready 1\n"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
}

TEST(ServiceTally, IsReadyWhereARequestWouldBeTakenAndWorkedOn) {
  ServiceTally tally;
  EXPECT_TRUE(tally.is_alive());
  EXPECT_FALSE(tally.is_ready());
  tally.note(at_work());
  EXPECT_TRUE(tally.is_ready());
  for (const auto& spoil : std::vector<std::function<void(ServiceTally::Totals&)>>{
           [](auto& totals) { totals.board.threads = 0; },
           [](auto& totals) { totals.desk.takes_writes = false; },
           [](auto& totals) { totals.status.accepting = false; }}) {
    ServiceTally::Totals totals = at_work();
    spoil(totals);
    tally.note(totals);
    EXPECT_FALSE(tally.is_ready());
    EXPECT_TRUE(tally.is_alive());
  }
}

}  // namespace
}  // namespace accord
