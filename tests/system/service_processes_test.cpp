// The whole service in processes of its own: what comes back over the public topics is what one
// process plans, to the byte, on good days and bad ones.
#include <gtest/gtest.h>

#include <sys/resource.h>

#include "common/planning/random.h"
#include "tests/support/service_processes.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using testing::planned_here;
using testing::request_for;
using testing::ServiceProcesses;

#define ASSERT_PLANNED(answer, expected)                                \
  ASSERT_TRUE(answer) << static_cast<int>((answer).error().why) << ": " \
                      << (answer).error().reply.text;                   \
  EXPECT_EQ(canonical_bytes(*(answer)), expected)

TEST(Service, PlansAsOneProcessDoesWithAnyNumberOfWorkers) {
  ServiceProcesses service;
  service.start_coordinator();
  std::uint64_t seed = 0;
  for (const int workers : {1, 2, 4}) {
    while (static_cast<int>(service.workers().size()) < workers) service.start_worker();
    ++seed;
    for (const char* scene : {"adaptive-mobile", "peer-inlet", "low-mobile-16"}) {
      const auto answer = service.plan(request_for(scene, seed));
      ASSERT_PLANNED(answer, planned_here(scene, seed));
    }
  }
}

TEST(Service, FinishesWhatItHasAcceptedAfterItWasKilled) {
  const std::string expected = planned_here("mixed-floor");
  ServiceProcesses service;
  service.start_coordinator();
  service.start_worker();
  bool is_killed = false;
  const auto answer = service.plan(request_for("mixed-floor"), [&](const RequestState& state) {
    if (is_killed || state.phase != RequestPhase::kConflicts) return;
    service.kill_coordinator();
    service.start_coordinator();
    is_killed = true;
  });
  EXPECT_TRUE(is_killed);
  ASSERT_PLANNED(answer, expected);
}

TEST(Service, GoesOnWithNewWorkersWhenAllWereKilled) {
  const std::string expected = planned_here("mixed-floor");
  ServiceProcesses service;
  service.start_coordinator();
  service.start_worker();
  service.start_worker();
  bool are_killed = false;
  const auto answer = service.plan(request_for("mixed-floor"), [&](const RequestState& state) {
    if (are_killed || state.phase != RequestPhase::kConflicts) return;
    service.workers().clear();
    service.start_worker();
    are_killed = true;
  });
  EXPECT_TRUE(are_killed);
  ASSERT_PLANNED(answer, expected);
}

TEST(Service, KeepsInItsJournalWhatItDoesNotFinishWhenAskedToEnd) {
  const std::string expected = planned_here("mixed-floor");
  ServiceProcesses service;
  service.start_coordinator();
  service.start_worker();
  bool is_ended = false;
  const auto answer = service.plan(request_for("mixed-floor"), [&](const RequestState& state) {
    if (is_ended || state.phase != RequestPhase::kConflicts) return;
    service.coordinator().signal(SIGTERM);
    EXPECT_EQ(service.coordinator().wait(), 0);
    service.start_coordinator();
    is_ended = true;
  });
  EXPECT_TRUE(is_ended);
  ASSERT_PLANNED(answer, expected);
}

TEST(Service, ServesAFinishedPlanAgainAfterARestart) {
  ServiceProcesses service;
  service.start_coordinator();
  service.start_worker();
  const auto first = service.plan(request_for("peer-inlet"));
  ASSERT_TRUE(first);
  // Asked to end, it waits for the disk: a plan is handed out before it is in the journal.
  service.coordinator().signal(SIGTERM);
  EXPECT_EQ(service.coordinator().wait(), 0);
  service.workers().clear();  // nobody is there to plan it anew
  service.start_coordinator();
  const auto again = service.plan(request_for("peer-inlet"));
  ASSERT_TRUE(again);
  EXPECT_EQ(to_json(*again), to_json(*first)) << "the very same, its times included";
}

TEST(Service, RefusesWhatMakesNoSense) {
  ServiceProcesses service;
  service.start_coordinator();
  PlanRequest request = request_for("peer-inlet");
  request.scene_text = "accord: scene/1\nname: x\nmodels: {}\nrobots: 5\n";
  const auto answer = service.plan(request);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().why, NoAnswer::Why::kRejected);
  EXPECT_EQ(answer.error().reply.reason, Rejection::kBadScene);
  EXPECT_NE(answer.error().reply.text.find("robots"), std::string::npos)
      << answer.error().reply.text;
}

TEST(Service, FindsOutAWorkerThatReturnsWhatDoesNotHold) {
  const std::string expected = planned_here("low-mobile-16");
  ServiceProcesses service;
  service.start_coordinator();
  testing::ChildProcess& liar = service.start_worker_program({CROOKED_WORKER, "lie"});
  ASSERT_TRUE(service.wait_for_worker("welcome"));
  const auto answer = service.plan(request_for("low-mobile-16"), [&](const RequestState&) {
    if (service.workers().size() == 1) service.start_worker();  // one that is honest
  });
  ASSERT_PLANNED(answer, expected);
  const auto outcast = service.wait_for_worker("distrusted");
  ASSERT_TRUE(outcast);
  EXPECT_NE(outcast->text.find("faster than it can"), std::string::npos) << outcast->text;
  liar.signal(SIGTERM);
  EXPECT_EQ(liar.wait(), 0);
}

TEST(Service, PlansTheSameWhenResultsComeAgainAndOutOfOrder) {
  const std::string expected = planned_here("low-mobile-16");
  ServiceProcesses service;
  service.start_coordinator();
  testing::ChildProcess& worker = service.start_worker_program({CROOKED_WORKER, "repeat"});
  const auto answer = service.plan(request_for("low-mobile-16"));
  ASSERT_PLANNED(answer, expected);
  worker.signal(SIGTERM);
  EXPECT_EQ(worker.wait(), 0);
}

TEST(Service, ReportsAWorkerOfAnotherProtocol) {
  ServiceProcesses service;
  service.start_coordinator();
  DdsOptions strange = service.options();
  strange.protocol = kProtocol + 1;
  auto stranger = make_dds_bus(Role::kWorker, strange);
  ASSERT_TRUE(stranger) << stranger.error();
  Announcement announcement;
  announcement.protocol = kProtocol + 1;
  announcement.threads = 1;
  std::optional<WorkerStatus> status;
  for (const auto end = std::chrono::steady_clock::now() + 10s;
       !status && std::chrono::steady_clock::now() < end;) {
    (*stranger)->publish({}, announcement);
    service.port().wait(50ms);
    while (auto news = service.port().take()) {
      if (auto* worker = std::get_if<WorkerStatus>(&*news)) status = *worker;
    }
  }
  ASSERT_TRUE(status);
  EXPECT_EQ(status->standing, "refused");
  EXPECT_EQ(status->text, "it speaks protocol 2; this coordinator speaks 1");
}

}  // namespace
}  // namespace accord
