// Workers on a simulated network, and all that may befall them. Their desks, scenes and solvers are
// the real ones; the loop, its threads and the time that work takes are simulated. The same seed
// and the same calls give the same run.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "common/planning/random.h"
#include "common/transport/simulated_network.h"
#include "worker/service/scene_shelf.h"
#include "worker/service/task_desk.h"

namespace accord::testing {

// What jobs have come to, whichever worker solved them first: what comes back depends on the job
// alone, so that a campaign need not solve it a thousand times.
class SolvedJobs {
 public:
  ResultItem solve(const SceneShelf& shelf, const TaskDesk::Job& job) {
    auto [known, is_new] = results_.try_emplace({job.scene, job.hierarchy, job.subproblem});
    if (is_new) known->second = shelf.solve(job, never_).result;
    ResultItem result = known->second;
    if (result.outcome != ResultItem::Outcome::kDone) results_.erase(known);
    return result;
  }

 private:
  const std::atomic<bool> never_{false};
  std::map<std::tuple<SceneHash, Bytes, Bytes>, ResultItem> results_;
};

// A worker process with its loop and its threads, on the network's clock.
class SimulatedWorker {
 public:
  using Time = Bus::Duration;

  SimulatedWorker(SimulatedNetwork& network, std::uint64_t seed, std::uint32_t protocol,
                  SolvedJobs& solved)
      : bus_(network.join(Role::kWorker, protocol)),
        desk_(settings(protocol)),
        random_(seed),
        solved_(solved) {}

  EndpointId id() const { return bus_->self(); }
  bool dead = false;
  bool frozen = false;
  std::function<void(const TaskDesk::Job&, Bytes& resolution)> lie;

  bool is_running() const { return !dead && !frozen; }

  void step(Time now) {
    while (const auto event = bus_->take()) desk_.on_event(*event, now);
    desk_.on_time(now);
    while (auto scene = desk_.take_scene()) {
      const auto added = shelf_.add(scene->hash, scene->bytes);
      added ? desk_.on_scene_ready(scene->hash)
            : desk_.on_scene_unusable(scene->hash, added.error());
    }
    for (const SceneHash& scene : desk_.take_forgotten()) shelf_.remove(scene);
    while (auto job = desk_.next_job(now)) {
      const auto takes = std::chrono::milliseconds(1 + random_.below(25));
      running_.push_back({std::move(*job), now + takes, std::chrono::duration<double>(takes)});
    }
    desk_.take_revoked();  // they end soon enough
    for (auto run = running_.begin(); run != running_.end();) {
      if (run->done_at > now) {
        ++run;
        continue;
      }
      ResultItem result = solved_.solve(shelf_, run->job);
      result.seconds = run->took.count();  // not what it took here, which no seed repeats
      if (lie && !result.resolution.empty()) lie(run->job, result.resolution);
      desk_.on_ended(run->job, std::move(result));
      run = running_.erase(run);
    }
    while (const auto out = desk_.next_outgoing(now)) {
      desk_.on_published(bus_->publish(out->to, out->message), now);
    }
  }
  Time next() const {
    Time next = desk_.next_deadline().value_or(Time::max());
    for (const Run& run : running_) next = std::min(next, run.done_at);
    return next;
  }

 private:
  struct Run {
    TaskDesk::Job job;
    Time done_at;
    std::chrono::duration<double> took;
  };

  static TaskDesk::Settings settings(std::uint32_t protocol) {
    TaskDesk::Settings settings;
    settings.info.protocol = protocol;
    settings.info.threads = 2;
    settings.info.task_bytes = 1 << 20;
    settings.info.scene_bytes = 1 << 24;
    return settings;
  }

  std::unique_ptr<Bus> bus_;
  TaskDesk desk_;
  SceneShelf shelf_;
  RandomStream random_;
  SolvedJobs& solved_;
  std::list<Run> running_;
};

class SimulatedCluster {
 public:
  using Time = Bus::Duration;

  // `solved` may be shared with other clusters, and must outlive this; null: it is this one's own.
  explicit SimulatedCluster(std::uint64_t seed, SolvedJobs* solved = nullptr)
      : network_(seed), random_(seed), solved_(solved != nullptr ? *solved : own_solved_) {}

  SimulatedNetwork& network() { return network_; }
  Time now() const { return network_.now(); }

  SimulatedWorker& start_worker(std::uint32_t protocol = kProtocol) {
    const std::uint64_t seed = random_.below(1 << 30);
    return *workers_.emplace_back(
        std::make_unique<SimulatedWorker>(network_, seed, protocol, solved_));
  }

  // All workers do what is due. Then the clock moves on: to when something happens next, or to the
  // deadline, whichever comes first.
  void pass(std::optional<Time> deadline) {
    const Time now = network_.now();
    Time next = now + std::chrono::milliseconds(20);
    if (deadline) next = std::min(next, *deadline);
    for (const auto& worker : workers_) {
      if (worker->is_running()) worker->step(now);
    }
    if (const auto due = network_.next()) next = std::min(next, *due);
    for (const auto& worker : workers_) {
      if (worker->is_running()) next = std::min(next, worker->next());
    }
    network_.advance_to(std::max(next, now + std::chrono::microseconds(10)));
  }

  // Something befalls one of the workers, or the messages between them and their coordinator; or
  // nothing does. Requires: there are workers.
  void strike(EndpointId coordinator) {
    SimulatedWorker& victim = *workers_[random_.below(workers_.size())];
    switch (random_.below(12)) {
      case 0:
        kill(victim);
        start_worker();
        break;
      case 1:
        network_.cut(coordinator, victim.id());
        break;
      case 2:
        network_.heal(coordinator, victim.id());
        break;
      case 3:
        network_.set_faults({0.1 * static_cast<double>(random_.below(4)), 0.1, 0.3});
        break;
      case 4:
        network_.set_faults({});
        break;
      case 5:
        if (!victim.dead) network_.freeze(victim.id());
        victim.frozen = true;
        break;
      case 6:
        thaw(victim);
        break;
      case 7:
        start_worker(kProtocol + 1);
        break;
      case 8:
        start_worker().lie = [own = std::uint8_t(random_.below(256))](const auto&,
                                                                      Bytes& resolution) {
          resolution.resize(3);
          resolution.push_back(own);
        };
        break;
      default:
        break;
    }
  }

  // No more faults, and whoever lives can be reached.
  void calm(EndpointId coordinator) {
    network_.set_faults({});
    for (const auto& worker : workers_) {
      network_.heal(coordinator, worker->id());
      thaw(*worker);
    }
  }

 private:
  void kill(SimulatedWorker& worker) {
    if (!worker.dead) network_.kill(worker.id());
    worker.dead = true;
  }
  void thaw(SimulatedWorker& worker) {
    if (!std::exchange(worker.frozen, false) || worker.dead) return;
    network_.thaw(worker.id());
  }

  SimulatedNetwork network_;
  RandomStream random_;
  SolvedJobs own_solved_;
  SolvedJobs& solved_;
  std::vector<std::unique_ptr<SimulatedWorker>> workers_;
};

}  // namespace accord::testing
