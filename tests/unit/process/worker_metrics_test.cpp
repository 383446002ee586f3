// What /metrics says of a worker.
#include "worker/main/worker_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace accord {
namespace {

using ::testing::HasSubstr;

constexpr WorkerTally::Load kAtWork{1, 3, true, false, {}};

TEST(WorkerMetrics, FollowTheTally) {
  WorkerTally tally;
  Metrics metrics;
  add_worker_metrics(metrics, tally, 8);
  EXPECT_THAT(metrics.collect(), HasSubstr("accord_worker_threads 8\n"));
  EXPECT_THAT(metrics.collect(), HasSubstr("accord_worker_employed 0\n"));

  ResultItem result;
  result.seconds = 0.25;
  const TriedLevel first{"prioritized-query", LevelOutcome::kExhausted};
  const TriedLevel second{"decoupled-prm", LevelOutcome::kSolved};
  tally.count(result, {first});
  tally.count(result, {first, second});
  result.outcome = ResultItem::Outcome::kFailed;
  tally.count(result, {});
  tally.note_turn(kAtWork);
  const std::string text = metrics.collect();
  for (const char* line :
       {"accord_worker_tasks_total{outcome=\"done\"} 2\n",
        "accord_worker_tasks_total{outcome=\"failed\"} 1\n",
        "accord_worker_tasks_total{outcome=\"refused\"} 0\n",
        "accord_worker_task_seconds_sum{solver=\"decoupled-prm\"} 0.25\n",
        "accord_worker_task_seconds_count{solver=\"prioritized-query\"} 1\n",
        "accord_worker_attempts_total{outcome=\"exhausted\",solver=\"prioritized-query\"} 2\n",
        "accord_worker_attempts_total{outcome=\"solved\",solver=\"decoupled-prm\"} 1\n",
        "accord_worker_busy_threads 1\n", "accord_worker_tasks_waiting 3\n",
        "accord_worker_employed 1\n", "accord_ready 1\n"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
}

TEST(WorkerTally, CountsTheTimeOfThreadsWhileTheyWorkNotWhenTheyHaveDone) {
  WorkerTally tally;
  tally.note_turn(kAtWork);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  tally.note_turn(kAtWork);
  EXPECT_GE(tally.totals().busy_seconds, 0.02);
  EXPECT_EQ(tally.totals().ended[0], 0U);
}

TEST(WorkerTally, IsNotReadyForWorkOnceItLeaves) {
  WorkerTally tally;
  EXPECT_FALSE(tally.is_ready());
  tally.note_turn(kAtWork);
  EXPECT_TRUE(tally.is_ready());
  auto leaving = kAtWork;
  leaving.is_leaving = true;
  tally.note_turn(leaving);
  EXPECT_FALSE(tally.is_ready());
}

// Its counters would fall, which counters must not.
TEST(WorkerTally, GoesOnCountingMessagesOnTheNextBus) {
  WorkerTally tally;
  auto load = kAtWork;
  load.bus.kinds[0].received = 5;
  tally.note_turn(load);
  tally.note_new_bus();
  EXPECT_EQ(tally.totals().load.bus.kinds[0].received, 5U);
  load.bus.kinds[0].received = 2;
  tally.note_turn(load);
  EXPECT_EQ(tally.totals().load.bus.kinds[0].received, 7U);
}

}  // namespace
}  // namespace accord
