// The whole service on threads of one process: a coordinator's loop with its threads, workers'
// loops with theirs, DDS between them, and fleet managers on threads of their own. Made for the
// thread sanitizer: see docs/development.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <list>
#include <map>
#include <thread>

#include "client/engine/planner.h"
#include "client/fleet/fleet_manager.h"
#include "client/fleet/request_file.h"
#include "common/io/plan_file.h"
#include "common/planning/method_names.h"
#include "common/transport/fleet/simulated_fleet.h"
#include "coordinator/journal/memory_journal.h"
#include "coordinator/service/coordinator_loop.h"
#include "tests/contract/dds_world.h"
#include "worker/service/worker_loop.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

std::unique_ptr<Bus> join(Role role, const DdsOptions& options) {
  auto bus = make_dds_bus(role, options);
  if (!bus) throw std::runtime_error(bus.error());
  return std::move(*bus);
}

// What accord-coordinator runs, on a thread.
class Coordinator {
 public:
  Coordinator(const DdsOptions& options, SimulatedFleet& fleet, Journal& journal)
      : bus_(join(Role::kCoordinator, options)),
        port_(fleet.serve([this] { bus_->wake(); })),
        loop_(settings(), *bus_, *port_, journal, tally_),
        thread_([this] { EXPECT_EQ(loop_.run(), std::nullopt); }) {}
  ~Coordinator() {
    loop_.drain();
    thread_.join();
  }
  Coordinator(const Coordinator&) = delete;
  Coordinator& operator=(const Coordinator&) = delete;

  const ServiceTally& tally() const { return tally_; }

 private:
  static CoordinatorLoop::Settings settings() {
    CoordinatorLoop::Settings settings;
    settings.desk.planning = settings.planning.planning = 2;
    settings.planning.limits.methods = method_names();
    settings.planning.limits.solvers = local_solver_names();
    return settings;
  }

  std::unique_ptr<Bus> bus_;
  std::unique_ptr<FleetServicePort> port_;
  ServiceTally tally_;
  CoordinatorLoop loop_;
  std::thread thread_;
};

// What accord-worker runs, on a thread.
class Worker {
 public:
  explicit Worker(const DdsOptions& options)
      : bus_(join(Role::kWorker, options)),
        loop_(*bus_, settings(), tally_),
        thread_([this] { loop_.run(); }) {}
  ~Worker() {
    loop_.drain();
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

 private:
  static TaskDesk::Settings settings() {
    TaskDesk::Settings settings;
    settings.info.threads = 1;
    settings.info.task_bytes = settings.info.scene_bytes = std::uint64_t{1} << 24;
    return settings;
  }

  std::unique_ptr<Bus> bus_;
  WorkerTally tally_;
  WorkerLoop loop_;
  std::thread thread_;
};

PlanRequest request_for(const std::string& scene, std::uint64_t seed) {
  PlanRequest request = request_for_scene(ACCORD_SOURCE_DIR "/scenes/" + scene + ".yaml").request;
  request.id = scene + "-" + std::to_string(seed);
  request.seed = seed;
  return request;
}

// One task that no worker ends by itself.
PlanRequest endless_request() {
  PlanRequest request = request_for("low-mobile-16", 1);
  request.id = "endless";
  request.method = "composite-prm";
  return request;
}

std::string planned_here(const std::string& scene, std::uint64_t seed) {
  PlanOptions options;
  options.seed = seed;
  const auto file = request_for_scene(ACCORD_SOURCE_DIR "/scenes/" + scene + ".yaml");
  return canonical_bytes(plan(file.scene, options));
}

class ServiceThreads : public ::testing::Test {
 protected:
  void start_coordinator() { coordinator_.emplace(options_, fleet_, journal_); }
  void start_worker() { workers_.emplace_back(options_); }

  // On a fleet manager's thread; by id.
  std::map<std::string, Plan> plan(const std::vector<PlanRequest>& requests) {
    const auto port = fleet_.join();
    FleetManager::Settings patient;
    patient.patience = 60s;
    FleetManager manager(*port, patient);
    for (const PlanRequest& request : requests) manager.submit(request);
    std::map<std::string, Plan> plans;
    const auto give_up = Clock::now() + 120s;
    while (manager.is_waiting() && Clock::now() < give_up) {
      auto event = manager.next(20ms);
      if (!event) continue;
      if (auto* finished = std::get_if<Plan>(&event->what)) {
        EXPECT_TRUE(plans.emplace(event->id, std::move(*finished)).second) << event->id;
      } else if (const auto* none = std::get_if<NoAnswer>(&event->what)) {
        ADD_FAILURE() << event->id << ": " << none->reply.text;
      }
    }
    return plans;
  }
  void wait_until(const std::function<bool()>& condition) {
    const auto give_up = Clock::now() + 60s;
    while (!condition()) {
      ASSERT_LT(Clock::now(), give_up) << "waits forever";
      std::this_thread::sleep_for(1ms);
    }
  }
  void wait_until_workers_work() {
    wait_until([&] { return coordinator_->tally().totals().unfinished_tasks > 0; });
  }

  DdsOptions options_ = local_dds(DdsOptions::Transport::kUdp);
  SimulatedFleet fleet_{1};
  MemoryJournal journal_;
  std::optional<Coordinator> coordinator_;
  std::list<Worker> workers_;
};

TEST_F(ServiceThreads, PlanForSeveralFleetManagersAtOnceAsOneProcessDoes) {
  start_coordinator();
  start_worker();
  start_worker();
  const std::vector<std::string> scenes{"peer-inlet", "low-mobile-08", "adaptive-mobile"};
  std::vector<std::future<std::map<std::string, Plan>>> managers;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    managers.push_back(std::async(std::launch::async, [&, seed] {
      std::vector<PlanRequest> requests;
      for (const std::string& scene : scenes) requests.push_back(request_for(scene, seed));
      return plan(requests);
    }));
  }
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto plans = managers[seed - 1].get();
    for (const std::string& scene : scenes) {
      const auto found = plans.find(scene + "-" + std::to_string(seed));
      ASSERT_NE(found, plans.end()) << scene;
      EXPECT_EQ(canonical_bytes(found->second), planned_here(scene, seed)) << scene << seed;
    }
  }
  EXPECT_EQ(journal_.counts()->finished, 9U);
}

TEST_F(ServiceThreads, FreeTheirWorkersWhenARequestIsCancelled) {
  start_coordinator();
  start_worker();
  const auto port = fleet_.join();
  FleetManager manager(*port, {});
  manager.submit(endless_request());
  wait_until([&] {
    manager.next(5ms);
    return coordinator_->tally().totals().unfinished_tasks > 0;
  });
  std::this_thread::sleep_for(50ms);  // the worker is deep in it
  const auto cancelled = Clock::now();
  manager.cancel("endless");
  manager.submit(request_for("peer-inlet", 1));
  std::map<std::string, Plan> plans;
  while (manager.is_waiting() && Clock::now() < cancelled + 60s) {
    auto event = manager.next(5ms);
    if (!event || !std::holds_alternative<Plan>(event->what)) continue;
    plans.emplace(event->id, std::get<Plan>(std::move(event->what)));
  }
  const double took = std::chrono::duration<double>(Clock::now() - cancelled).count();
  RecordProperty("seconds_until_the_worker_had_planned_another", std::to_string(took));
  EXPECT_LT(took, 2) << "30 ms on a machine that does nothing else";
  ASSERT_EQ(plans.size(), 2U);
  EXPECT_EQ(plans.at("endless").status, PlanStatus::kCancelled);
  EXPECT_EQ(canonical_bytes(plans.at("peer-inlet-1")), planned_here("peer-inlet", 1));
}

TEST_F(ServiceThreads, EndSoonWhenDrainedAndLeaveWhatTheyPlanToTheNextOnes) {
  start_coordinator();
  start_worker();
  auto manager = std::async(std::launch::async, [&] {
    return plan({endless_request(), request_for("adaptive-mobile", 1)});
  });
  wait_until_workers_work();
  const auto drained = Clock::now();
  coordinator_.reset();
  const double took = std::chrono::duration<double>(Clock::now() - drained).count();
  RecordProperty("seconds_to_end", std::to_string(took));
  EXPECT_LT(took, 5);
  EXPECT_FALSE((*journal_.find("endless"))->outcome) << "it is for the next one";

  start_coordinator();
  wait_until_workers_work();
  const auto canceller = fleet_.join();
  while (manager.wait_for(20ms) != std::future_status::ready) {
    canceller->send(CancelRequest{"endless"});
  }
  const auto plans = manager.get();
  EXPECT_EQ(plans.at("endless").status, PlanStatus::kCancelled);
  EXPECT_EQ(canonical_bytes(plans.at("adaptive-mobile-1")), planned_here("adaptive-mobile", 1));
}

TEST_F(ServiceThreads, GoOnWhileWorkersComeAndGo) {
  start_coordinator();
  start_worker();
  auto manager = std::async(std::launch::async, [&] {
    return plan({request_for("adaptive-mobile", 1), request_for("mixed-floor", 1)});
  });
  wait_until_workers_work();
  start_worker();
  workers_.pop_front();
  start_worker();
  const auto plans = manager.get();
  for (const std::string scene : {"adaptive-mobile", "mixed-floor"}) {
    ASSERT_TRUE(plans.contains(scene + "-1"));
    EXPECT_EQ(canonical_bytes(plans.at(scene + "-1")), planned_here(scene, 1));
  }
}

}  // namespace
}  // namespace accord
