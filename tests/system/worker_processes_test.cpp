// Real worker processes over DDS on 127.0.0.1: planning with them, and what happens when they are
// killed, stopped, and asked to end.
#include <gtest/gtest.h>

#include <csignal>
#include <functional>
#include <list>
#include <string>
#include <thread>

#include "coordinator/dispatch/direct_port.h"
#include "coordinator/dispatch/remote_crew.h"
#include "tests/contract/dds_world.h"
#include "tests/support/child_process.h"
#include "tests/support/planned_paths.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class WorkerProcess : public testing::ChildProcess {
 public:
  explicit WorkerProcess(const DdsOptions& options)
      : ChildProcess({ACCORD_WORKER, "--domain", std::to_string(options.domain), "--cluster",
                      options.cluster, "--transport", "udp", "--interface", "127.0.0.1", "--log",
                      "off"}) {}
};

class WorkerProcesses : public ::testing::Test {
 protected:
  WorkerProcesses() : options_(local_dds(DdsOptions::Transport::kUdp)) { join(); }

  void join() {
    auto bus = make_dds_bus(Role::kCoordinator, options_);
    if (!bus) throw std::runtime_error(bus.error());
    bus_ = std::move(*bus);
  }

  void start_worker() { workers_.emplace_back(options_); }

  // Plans with whoever is there; `at_turn` is called at every turn of the loop.
  std::vector<Trajectory> plan(const std::shared_ptr<const Scene>& scene,
                               const std::function<void()>& at_turn = {}) {
    const auto began = Clock::now();
    const auto turn = [&](Bus& bus, std::optional<TaskBoard::Time> deadline) {
      if (Clock::now() - began > 60s) throw std::runtime_error("stuck");
      if (at_turn) at_turn();
      const TaskBoard::Time now = Clock::now() - began_;
      auto wait = TaskBoard::Time(50ms);
      if (deadline) wait = std::clamp(*deadline - now, TaskBoard::Time(0), wait);
      bus.wait_for_event(wait);
      return TaskBoard::Time(Clock::now() - began_);
    };
    const CollisionWorld world(scene, kDetectionMargin);
    Foreman workforce(std::make_unique<RemoteCrew>(
                          std::make_unique<DirectPort>(*bus_, board_, ++request_, turn), world),
                      default_solver_names());
    return testing::planned_paths(scene, workforce);
  }

  DdsOptions options_;
  std::unique_ptr<Bus> bus_;
  TaskBoard board_{TaskBoard::Settings{}};
  Clock::time_point began_ = Clock::now();
  RequestId request_ = 0;
  std::list<WorkerProcess> workers_;
};

TEST_F(WorkerProcesses, PlanAsOneProcessDoes) {
  start_worker();
  for (const char* name : {"peer-inlet", "adaptive-mobile", "mixed-cell"}) {
    const auto scene = testing::example_scene(name);
    EXPECT_EQ(plan(scene), testing::paths_planned_in_process(scene)) << name;
  }
  start_worker();
  const auto scene = testing::example_scene("low-mobile-32");
  EXPECT_EQ(plan(scene), testing::paths_planned_in_process(scene));
  EXPECT_EQ(board_.counters().reassigned(), 0U);
}

TEST_F(WorkerProcesses, MayBeKilledAtAnyMoment) {
  const auto scene = testing::example_scene("mixed-floor");
  const auto expected = testing::paths_planned_in_process(scene);
  start_worker();
  start_worker();
  // Each time a few more tasks have been given out.
  int killed = 0;
  const auto paths = plan(scene, [&] {
    if (board_.counters().assigned < 4 * static_cast<std::uint64_t>(killed + 1) || killed == 4) {
      return;
    }
    workers_.pop_front();  // kill -9
    start_worker();
    ++killed;
  });
  EXPECT_EQ(paths, expected);
  EXPECT_GT(killed, 0);
}

TEST_F(WorkerProcesses, MayHangPastTheirLeaseAndComeBack) {
  const auto scene = testing::example_scene("mixed-floor");
  const auto expected = testing::paths_planned_in_process(scene);
  start_worker();
  start_worker();
  std::optional<Clock::time_point> stopped;
  const auto hang = [&] {
    if (!stopped && board_.counters().assigned >= 4) {
      workers_.front().signal(SIGSTOP);
      stopped = Clock::now();
    }
    if (stopped && Clock::now() >= *stopped + 1500ms) workers_.front().signal(SIGCONT);
  };
  EXPECT_EQ(plan(scene, hang), expected);
  EXPECT_TRUE(stopped);
  workers_.front().signal(SIGCONT);
}

// Past the lease of DDS, which may keep it apart for good.
TEST_F(WorkerProcesses, AreFoundAgainWhereTheyWereForgotten) {
  const auto scene = testing::example_scene("peer-inlet");
  const auto expected = testing::paths_planned_in_process(scene);
  start_worker();
  EXPECT_EQ(plan(scene), expected);
  workers_.front().signal(SIGSTOP);
  for (const auto end = Clock::now() + 3s; Clock::now() < end;) {
    while (const auto event = bus_->take()) board_.on_event(*event, Clock::now() - began_);
    bus_->wait_for_event(50ms);
  }
  workers_.front().signal(SIGCONT);
  EXPECT_EQ(plan(scene), expected);
}

// So long that they have joined anew meanwhile.
TEST_F(WorkerProcesses, WorkForTheCoordinatorThatComesAfterOneThatIsGone) {
  const auto scene = testing::example_scene("peer-inlet");
  start_worker();
  const auto expected = plan(scene);
  bus_.reset();
  std::this_thread::sleep_for(6s);
  board_ = TaskBoard(TaskBoard::Settings{});
  join();
  EXPECT_EQ(plan(scene), expected);
}

TEST_F(WorkerProcesses, EndInOrderWhenAskedTo) {
  start_worker();
  const auto scene = testing::example_scene("peer-inlet");
  plan(scene);
  workers_.front().signal(SIGTERM);
  EXPECT_EQ(workers_.front().wait(), 0);
}

}  // namespace
}  // namespace accord
