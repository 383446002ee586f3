// Plans a scene over DDS on this machine, with real worker processes of one thread, and prints as
// JSON what that took: one object a run. The processes have seen nothing of the scene before the
// first run; in later ones they are warm, as a service's are. tests/bench/scaling makes a table.
//
//   scaling_run SCENE.yaml WORKERS shm|udp RUNS
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <list>
#include <optional>
#include <stdexcept>
#include <string>

#include "common/io/scene_file.h"
#include "coordinator/dispatch/direct_port.h"
#include "coordinator/dispatch/remote_crew.h"
#include "coordinator/planner.h"
#include "tests/bench/scalability/cpu_clock.h"
#include "tests/contract/dds_world.h"
#include "tests/support/child_process.h"

namespace accord::bench {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

double seconds(Clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

// Passes everything on, and notes what is of interest.
class WatchedBus final : public Bus {
 public:
  explicit WatchedBus(std::unique_ptr<Bus> bus)
      : Bus(bus->self(), bus->role()), bus_(std::move(bus)) {}

  void begin() {
    began_ = Clock::now();
    first_task.reset();
    tasks = 0;
    busy = 0;
    before_ = bus_->counters();
  }
  std::optional<double> first_task;  // s after begin()
  std::uint64_t tasks = 0;           // results, of whatever kind
  double busy = 0;                   // s: of workers, as they say

  // Messages and their bytes since begin(), both ways.
  std::pair<std::uint64_t, std::uint64_t> traffic() const {
    std::pair<std::uint64_t, std::uint64_t> out;
    for (std::size_t kind = 0; kind < kMessageKinds; ++kind) {
      const auto &now = bus_->counters().kinds[kind], &then = before_.kinds[kind];
      out.first += now.sent + now.received - then.sent - then.received;
      out.second += now.sent_bytes + now.received_bytes - then.sent_bytes - then.received_bytes;
    }
    return out;
  }

 private:
  Published do_publish(EndpointId to, const Message& message) override {
    const Published outcome = bus_->publish(to, message);
    if (!first_task && std::holds_alternative<TaskBatch>(message)) {
      first_task = seconds(Clock::now() - began_);
    }
    return outcome;
  }
  std::optional<BusEvent> do_take() override {
    auto event = bus_->take();
    if (!event) return event;
    const auto* message = std::get_if<Message>(&event->what);
    const auto* results = message ? std::get_if<ResultBatch>(message) : nullptr;
    if (results == nullptr) return event;
    tasks += results->results.size();
    for (const ResultItem& item : results->results) busy += item.seconds;
    return event;
  }
  bool do_wait(Duration timeout) override { return bus_->wait_for_event(timeout); }
  void do_wake() override { bus_->wake(); }

  std::unique_ptr<Bus> bus_;
  Clock::time_point began_;
  BusCounters before_;
};

class Service {
 public:
  Service(std::shared_ptr<const Scene> scene, unsigned workers, DdsOptions::Transport transport)
      : scene_(std::move(scene)), threads_(workers) {
    const DdsOptions options = local_dds(transport);
    auto bus = make_dds_bus(Role::kCoordinator, options);
    if (!bus) throw std::runtime_error(bus.error());
    bus_.emplace(std::move(*bus));
    for (unsigned i = 0; i < workers; ++i) {
      workers_.emplace_back(std::vector<std::string>{
          ACCORD_WORKER, "--domain", std::to_string(options.domain), "--cluster", options.cluster,
          "--transport", transport == DdsOptions::Transport::kUdp ? "udp" : "shm", "--interface",
          "127.0.0.1", "--threads", "1", "--log", "off"});
    }
    const auto port = make_port();
    while (board_.threads() < workers) port->turn();
  }

  // Ended in order: who is killed leaves shared memory behind.
  ~Service() {
    for (const testing::ChildProcess& worker : workers_) worker.signal(SIGTERM);
    for (testing::ChildProcess& worker : workers_) worker.wait();
  }
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  std::string run() {
    PlanOptions options;
    options.threads = threads_;
    bus_->begin();
    const auto began = Clock::now();
    const double cpu = cpu_seconds();
    const Plan plan = plan_with(
        [this](const CollisionWorld&, const CollisionWorld& detection) {
          return std::make_unique<RemoteCrew>(make_port(), detection);
        },
        scene_, options);
    const double wall = seconds(Clock::now() - began);
    const double coordinator = cpu_seconds() - cpu;
    const auto [messages, bytes] = bus_->traffic();
    return fmt::format(
        R"({{"workers": {}, "solved": {}, "seconds": {:.6f}, "coordinator": {:.6f}, )"
        R"("busy": {:.6f}, "tasks": {}, "messages": {}, "bytes": {}, "first_task": {:.6f}}})",
        threads_, plan.status == PlanStatus::kSolved, wall, coordinator, bus_->busy, bus_->tasks,
        messages, bytes, bus_->first_task.value_or(0));
  }

 private:
  std::unique_ptr<DirectPort> make_port() {
    const auto turn = [this](Bus& bus, std::optional<TaskBoard::Time> deadline) {
      const TaskBoard::Time now = Clock::now() - began_;
      auto wait = TaskBoard::Time(50ms);
      if (deadline) wait = std::clamp(*deadline - now, TaskBoard::Time(0), wait);
      bus.wait_for_event(wait);
      return TaskBoard::Time(Clock::now() - began_);
    };
    return std::make_unique<DirectPort>(*bus_, board_, ++requests_, turn);
  }

  std::shared_ptr<const Scene> scene_;
  unsigned threads_;
  Clock::time_point began_ = Clock::now();
  std::optional<WatchedBus> bus_;
  TaskBoard board_{TaskBoard::Settings{}};
  RequestId requests_ = 0;
  std::list<testing::ChildProcess> workers_;
};

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: scaling_run SCENE.yaml WORKERS shm|udp RUNS\n";
    return 2;
  }
  const auto loaded = load_scene(argv[1]);
  const long workers = std::strtol(argv[2], nullptr, 10), runs = std::strtol(argv[4], nullptr, 10);
  if (!loaded.scene || workers < 1) {
    std::cerr << "scaling_run: no such scene, or no workers\n";
    return 2;
  }
  const auto transport = std::string(argv[3]) == "udp" ? DdsOptions::Transport::kUdp
                                                       : DdsOptions::Transport::kSharedMemory;
  Service service(loaded.scene, static_cast<unsigned>(workers), transport);
  for (long i = 0; i < runs; ++i) {
    std::cout << (i == 0 ? "[" : ",\n ") << service.run() << std::flush;
  }
  std::cout << "]\n";
  return 0;
}

}  // namespace
}  // namespace accord::bench

int main(int argc, char** argv) {
  return accord::bench::main(argc, argv);
}
