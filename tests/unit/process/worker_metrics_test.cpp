// What /metrics says of a worker.
#include "worker/main/worker_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace accord {
namespace {

using ::testing::HasSubstr;

TEST(WorkerMetrics, FollowTheTally) {
  WorkerTally tally;
  Metrics metrics;
  add_worker_metrics(metrics, tally, 8);
  EXPECT_THAT(metrics.collect(), HasSubstr("accord_worker_threads 8\n"));
  EXPECT_THAT(metrics.collect(), HasSubstr("accord_worker_employed 0\n"));

  ResultItem result;
  result.seconds = 0.25;
  tally.count(result);
  tally.count(result);
  result.outcome = ResultItem::Outcome::kFailed;
  tally.count(result);
  tally.set_employed(true);
  const std::string text = metrics.collect();
  EXPECT_THAT(text, HasSubstr("accord_worker_tasks_total{outcome=\"done\"} 2\n"));
  EXPECT_THAT(text, HasSubstr("accord_worker_tasks_total{outcome=\"failed\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("accord_worker_tasks_total{outcome=\"refused\"} 0\n"));
  EXPECT_THAT(text, HasSubstr("accord_worker_solving_seconds_total 0.75\n"));
  EXPECT_THAT(text, HasSubstr("accord_worker_employed 1\n"));
}

}  // namespace
}  // namespace accord
