// The service as real processes over DDS on 127.0.0.1: a coordinator, workers, and a fleet manager
// in the test itself.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "client/engine/planner.h"
#include "client/fleet/fleet_manager.h"
#include "client/fleet/request_file.h"
#include "common/io/plan_file.h"
#include "common/io/scene_file.h"
#include "common/transport/fleet/dds_fleet.h"
#include "tests/contract/dds_world.h"
#include "tests/support/child_process.h"
#include "tests/support/scratch_folder.h"

namespace accord::testing {

class ServiceProcesses {
 public:
  explicit ServiceProcesses(DdsOptions options = local_dds(DdsOptions::Transport::kUdp))
      : options_(std::move(options)) {
    auto port = make_dds_fleet_client(options_);
    if (!port) throw std::runtime_error(port.error());
    port_ = std::move(*port);
  }

  void start_coordinator(std::vector<std::string> more = {}) {
    std::vector<std::string> command{ACCORD_COORDINATOR, "--journal", journal().string(),
                                     "--quarantine", (folder_.path() / "quarantine").string()};
    command.insert(command.end(), more.begin(), more.end());
    coordinator_.emplace(with_dds(std::move(command)));
  }
  ChildProcess& coordinator() { return *coordinator_; }
  void kill_coordinator() { coordinator_.reset(); }

  void start_worker(unsigned threads = 1) {
    workers_.emplace_back(with_dds({ACCORD_WORKER, "--threads", std::to_string(threads)}));
  }
  // One of the test's own programs that speaks as a worker does; its words come before the flags.
  ChildProcess& start_worker_program(std::vector<std::string> command) {
    command.insert(command.end(), {"--threads", "1"});
    return workers_.emplace_back(with_dds(std::move(command)));
  }
  std::list<ChildProcess>& workers() { return workers_; }

  // What the service says of a worker that it holds to be this ("welcome", "refused", ...), within
  // some seconds.
  std::optional<WorkerStatus> wait_for_worker(const std::string& standing) {
    const auto port = make_dds_fleet_client(options_);  // its own: nobody else takes what it hears
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
         port && std::chrono::steady_clock::now() < end;
         (*port)->wait(std::chrono::milliseconds(50))) {
      while (auto news = (*port)->take()) {
        auto* worker = std::get_if<WorkerStatus>(&*news);
        if (worker != nullptr && worker->standing == standing) return *worker;
      }
    }
    return std::nullopt;
  }

  std::filesystem::path journal() const { return folder_.path() / "journal.db"; }
  const DdsOptions& options() const { return options_; }
  FleetClientPort& port() { return *port_; }

  // Submits a request and waits for what becomes of it, on this thread.
  tl::expected<Plan, NoAnswer> plan(const PlanRequest& request,
                                    const std::function<void(const RequestState&)>& on_state = {}) {
    FleetManager manager(*port_, {});
    const std::atomic<bool> stop{false};
    return manager.plan(request, on_state, stop);
  }

 private:
  std::vector<std::string> with_dds(std::vector<std::string> command) const {
    for (const std::string& word :
         {std::string("--domain"), std::to_string(options_.domain), std::string("--cluster"),
          options_.cluster, std::string("--transport"),
          std::string(options_.transport == DdsOptions::Transport::kUdp ? "udp" : "shm"),
          std::string("--interface"), std::string("127.0.0.1"), std::string("--log"),
          std::string("off")}) {
      command.push_back(word);
    }
    return command;
  }

  DdsOptions options_;
  ScratchFolder folder_;
  std::unique_ptr<FleetClientPort> port_;
  std::optional<ChildProcess> coordinator_;
  std::list<ChildProcess> workers_;
};

inline std::string scene_path(const std::string& name) {
  return ACCORD_SOURCE_DIR "/scenes/" + name + ".yaml";
}

inline PlanRequest request_for(const std::string& scene, std::uint64_t seed = 1) {
  PlanRequest request = request_for_scene(scene_path(scene)).request;
  request.id = scene + "-" + std::to_string(seed);
  request.seed = seed;
  return request;
}

// What the service has to give, to the byte.
inline std::string planned_here(const std::string& scene, std::uint64_t seed = 1) {
  PlanOptions options;
  options.seed = seed;
  return canonical_bytes(plan(load_scene(scene_path(scene)).scene, options));
}

}  // namespace accord::testing
