#include "client/watch/watched_fleet.h"

#include <gtest/gtest.h>

#include "tests/unit/client/watch/news.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using namespace watch_news;

std::vector<std::string> ids_of(const WatchedFleet& fleet, WatchTime now) {
  std::vector<std::string> out;
  for (const WatchedRequest* request : fleet.requests(now)) out.push_back(request->state.id);
  return out;
}

TEST(WatchedFleet, TellsWhatChangesAndNotThatTimePasses) {
  WatchedFleet fleet;
  RequestState state = state_of("a", RequestPhase::kConflicts, 1);
  EXPECT_TRUE(fleet.take(state, 0s));
  state.elapsed = 2;
  EXPECT_FALSE(fleet.take(state, 1s));
  state.conflicts_found = 3;
  EXPECT_TRUE(fleet.take(state, 1s));
  ServiceStatus service;
  EXPECT_TRUE(fleet.take(service, 1s));
  service.uptime = 5;
  EXPECT_FALSE(fleet.take(service, 2s));
  service.queued = 1;
  EXPECT_TRUE(fleet.take(service, 2s));
  EXPECT_TRUE(fleet.take(worker_of(1), 2s));
  EXPECT_FALSE(fleet.take(worker_of(1), 3s));
  EXPECT_FALSE(fleet.take(RequestReply{"a", true, Rejection::kNone, "", ""}, 3s));
}

TEST(WatchedFleet, CountsOnWhileARequestIsOnItsWay) {
  WatchedFleet fleet;
  fleet.take(state_of("a", RequestPhase::kConflicts, 1.5), 10s);
  EXPECT_DOUBLE_EQ(fleet.requests(12s)[0]->elapsed(12s), 3.5);
  fleet.take(state_of("a", RequestPhase::kFinished, 4), 13s);
  EXPECT_DOUBLE_EQ(fleet.requests(20s)[0]->elapsed(20s), 4);
}

TEST(WatchedFleet, TellsHowARequestEndedInWhateverOrderThatIsHeard) {
  for (const bool plan_first : {false, true}) {
    WatchedFleet fleet;
    fleet.take(state_of("a", RequestPhase::kProof, 1), 0s);
    if (plan_first) {
      EXPECT_FALSE(fleet.take(ended("a", PlanStatus::kSolved, 32), 1s)) << "not yet";
      EXPECT_TRUE(fleet.take(state_of("a", RequestPhase::kFinished, 2), 1s));
    } else {
      EXPECT_TRUE(fleet.take(state_of("a", RequestPhase::kFinished, 2), 1s));
      EXPECT_TRUE(fleet.take(ended("a", PlanStatus::kSolved, 32), 1s));
    }
    const WatchedRequest& request = *fleet.requests(1s)[0];
    ASSERT_TRUE(request.outcome && request.is_finished());
    EXPECT_EQ(request.outcome->makespan, 32);
    EXPECT_FALSE(fleet.take(ended("a", PlanStatus::kSolved, 32), 2s)) << "somebody asked again";
  }
}

TEST(WatchedFleet, PutsFirstWhatIsPlannedThenWhatWaitsThenWhatHasEndedLast) {
  WatchedFleet fleet;
  fleet.take(state_of("ended-early", RequestPhase::kFinished, 100), 1s);
  fleet.take(state_of("ended-late", RequestPhase::kFinished, 1), 2s);
  fleet.take(state_of("second", RequestPhase::kQueued, 9, 1), 3s);
  fleet.take(state_of("next", RequestPhase::kQueued, 1, 0), 3s);
  fleet.take(state_of("young", RequestPhase::kProof, 1), 3s);
  fleet.take(state_of("old", RequestPhase::kConflicts, 5), 3s);
  EXPECT_EQ(ids_of(fleet, 3s), (std::vector<std::string>{"old", "young", "next", "second",
                                                         "ended-late", "ended-early"}));
}

TEST(WatchedFleet, IsCompleteWhenItKnowsAllThatTheServiceCounts) {
  WatchedFleet fleet;
  EXPECT_FALSE(fleet.is_complete());
  fleet.take(service_of(2, 1, 1), 0s);
  EXPECT_FALSE(fleet.is_complete());
  fleet.take(worker_of(1), 0s);
  fleet.take(worker_of(2), 0s);
  fleet.take(state_of("a", RequestPhase::kQueued, 0), 0s);
  fleet.take(state_of("b", RequestPhase::kFinished, 0), 0s);
  EXPECT_FALSE(fleet.is_complete());
  fleet.take(state_of("c", RequestPhase::kProof, 0), 0s);
  EXPECT_TRUE(fleet.is_complete());
}

TEST(WatchedFleet, ShowsALostWorkerForAWhileUnlessItIsOneOfThePast) {
  WatchedFleet fleet;
  fleet.take(service_of(0, 0, 0), 0s);
  fleet.take(worker_of(1), 0s);
  EXPECT_FALSE(fleet.take(worker_of(1, "lost"), 10ms)) << "the history that a latecomer gets";
  EXPECT_FALSE(fleet.take(worker_of(2, "lost"), 10ms));
  EXPECT_TRUE(fleet.workers().empty());
  fleet.take(worker_of(3), 1s);
  EXPECT_TRUE(fleet.take(worker_of(3, "lost"), 5s));
  fleet.forget(14s);
  EXPECT_EQ(fleet.workers().size(), 1U);
  fleet.forget(16s);
  EXPECT_TRUE(fleet.workers().empty());
}

TEST(WatchedFleet, ForgetsWorkersOfWhichTheServiceSaysNothingMore) {
  WatchedFleet fleet;
  fleet.take(service_of(1, 0, 0), 0s);
  fleet.take(worker_of(1), 0s);
  fleet.set_present(true, 0s);
  fleet.set_present(false, 1s);
  fleet.forget(20s);
  EXPECT_EQ(fleet.workers().size(), 1U) << "there is nobody to say anything";
  fleet.take(service_of(0, 0, 0), 20s);
  fleet.forget(20s);
  EXPECT_TRUE(fleet.workers().empty());
}

TEST(WatchedFleet, ForgetsRequestsThatTheServiceHasNoMore) {
  WatchedFleet fleet;
  fleet.take(state_of("old", RequestPhase::kConflicts, 1), 0s);
  fleet.take(state_of("new", RequestPhase::kConflicts, 1), 9s);
  fleet.take(service_of(0, 0, 1), 9s);
  fleet.forget(10s);
  EXPECT_EQ(ids_of(fleet, 10s), std::vector<std::string>{"new"});
  fleet.take(service_of(0, 0, 0), 10s);
  fleet.forget(11s);
  EXPECT_EQ(ids_of(fleet, 11s), std::vector<std::string>{"new"}) << "its end may be on its way";
}

TEST(WatchedFleet, SaysThatTheServiceIsGoneOnceAndThatItIsBack) {
  WatchedFleet fleet;
  EXPECT_FALSE(fleet.set_present(false, 0s)) << "there was none";
  fleet.take(service_of(0, 0, 0), 1s);
  EXPECT_FALSE(fleet.set_present(false, 1s)) << "it is being found";
  EXPECT_FALSE(fleet.set_present(true, 1s));
  EXPECT_TRUE(fleet.set_present(false, 2s));
  EXPECT_FALSE(fleet.set_present(false, 3s));
  EXPECT_FALSE(fleet.set_present(true, 3s)) << "it has said nothing yet";
  EXPECT_TRUE(fleet.take(service_of(0, 0, 0), 4s));
}

TEST(WatchedFleet, NeverKeepsMoreThanItsBoundsAndDropsTheOldestEnds) {
  WatchedFleet fleet;
  constexpr std::size_t kMany = WatchedFleet::kFinished + 10;
  for (std::size_t i = 0; i < kMany; ++i) {
    fleet.take(state_of(std::to_string(i), RequestPhase::kFinished, 0), WatchTime(i));
  }
  EXPECT_EQ(fleet.requests(1s).size(), WatchedFleet::kFinished);
  EXPECT_EQ(fleet.requests(1s)[0]->state.id, std::to_string(kMany - 1));
  for (std::uint64_t i = 0; i < WatchedFleet::kWorkers + 10; ++i) fleet.take(worker_of(i), 0s);
  EXPECT_EQ(fleet.workers().size(), WatchedFleet::kWorkers);
}

}  // namespace
}  // namespace accord
