// A worker process like any other, but for what it sends back:
//
//   crooked_worker lie|repeat [flags of accord-worker]
//
// lie: resolutions that are a hair too fast. repeat: every result twice, and again, after others.
// Ended by SIGTERM it exits with 0 if it came to do so, else with 3.
#include <csignal>
#include <deque>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "common/geometry/collision_world.h"
#include "common/io/limits.h"
#include "common/io/wire/resolution_codec.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "common/runtime/command_line.h"
#include "common/runtime/ending_signals.h"
#include "common/transport/dds_bus.h"
#include "common/transport/scene_pieces.h"
#include "tests/simulation/lies.h"
#include "worker/main/worker_settings.h"
#include "worker/service/worker_loop.h"

namespace accord::testing {
namespace {

// Passes everything on; what is sent, as a kind of crooked bus would have it.
class CrookedBus : public Bus {
 public:
  explicit CrookedBus(std::unique_ptr<Bus> bus)
      : Bus(bus->self(), bus->role()), bus_(std::move(bus)) {}

  std::size_t misdeeds = 0;

 protected:
  virtual void on_taken(const Message&) {}
  virtual Published send(EndpointId to, const Message& message) = 0;
  Published pass_on(EndpointId to, const Message& message) { return bus_->publish(to, message); }

 private:
  Published do_publish(EndpointId to, const Message& message) override { return send(to, message); }
  std::optional<BusEvent> do_take() override {
    auto event = bus_->take();
    if (event) {
      if (const auto* message = std::get_if<Message>(&event->what)) on_taken(*message);
    }
    return event;
  }
  bool do_wait(Duration timeout) override { return bus_->wait_for_event(timeout); }
  void do_wake() override { bus_->wake(); }

  std::unique_ptr<Bus> bus_;
};

// Changes what solves a subproblem so that it does not.
class LyingBus final : public CrookedBus {
 public:
  using CrookedBus::CrookedBus;

 private:
  void on_taken(const Message& message) override {
    if (const auto* piece = std::get_if<ScenePiece>(&message)) {
      if (!pieces_) pieces_.emplace(piece->scene);
      pieces_->add(*piece);
      if (pieces_->complete() && !world_) world_.emplace(*decode_scene(*pieces_->take()), 0.0);
    } else if (const auto* batch = std::get_if<TaskBatch>(&message)) {
      for (const TaskItem& task : batch->tasks) tasks_.insert_or_assign(task.key, task.subproblem);
    }
  }
  Published send(EndpointId to, const Message& message) override {
    const auto* batch = std::get_if<ResultBatch>(&message);
    if (batch == nullptr) return pass_on(to, message);
    ResultBatch out = *batch;
    std::size_t lies = 0;
    for (ResultItem& item : out.results) {
      if (item.outcome == ResultItem::Outcome::kDone && lie(item)) ++lies;
    }
    const Published outcome = pass_on(to, out);
    if (outcome == Published::kSent) misdeeds += lies;
    return outcome;
  }
  bool lie(ResultItem& item) const {
    const auto subproblem = decode_subproblem(tasks_.at(item.key), world_->scene());
    auto resolution = decode_resolution(item.resolution, world_->scene(), *subproblem);
    if (!resolution->solved || !is_too_fast(*world_, *subproblem, *resolution)) return false;
    item.resolution = encode_resolution(*resolution);
    return true;
  }

  std::optional<SceneAssembly> pieces_;
  std::optional<CollisionWorld> world_;
  std::map<TaskKey, Bytes> tasks_;
};

class RepeatingBus final : public CrookedBus {
 public:
  using CrookedBus::CrookedBus;

 private:
  Published send(EndpointId to, const Message& message) override {
    const Published outcome = pass_on(to, message);
    const auto* batch = std::get_if<ResultBatch>(&message);
    if (batch == nullptr || outcome != Published::kSent) return outcome;
    repeat(to, *batch);
    for (const ResultBatch& old : old_) repeat(to, old);
    old_.push_front(*batch);  // the latest first: not in the order in which they came
    if (old_.size() > 4) old_.pop_back();
    return outcome;
  }
  void repeat(EndpointId to, const ResultBatch& batch) {
    if (pass_on(to, batch) == Published::kSent) ++misdeeds;
  }

  std::deque<ResultBatch> old_;
};

int run(std::string_view deed, int argc, char** argv) {
  WorkerSettings options;
  const Start start =
      start_up({"crooked_worker", "A worker for tests.", "0"}, worker_table(options), argc, argv);
  if (start.end) return static_cast<int>(*start.end);
  EndingSignals signals;
  auto honest = make_dds_bus(Role::kWorker, options.dds);
  if (!honest) {
    std::cerr << honest.error() << '\n';
    return 1;
  }
  std::unique_ptr<CrookedBus> bus;
  if (deed == "lie") bus = std::make_unique<LyingBus>(std::move(*honest));
  if (deed == "repeat") bus = std::make_unique<RepeatingBus>(std::move(*honest));
  if (bus == nullptr) {
    std::cerr << "crooked_worker: no deed '" << deed << "'; there are lie and repeat\n";
    return 2;
  }
  TaskDesk::Settings desk;
  desk.info.threads = options.threads;
  desk.info.task_bytes = limits::kSubproblemBytes;
  desk.info.scene_bytes = limits::kSceneWireBytes;
  WorkerTally tally;
  WorkerLoop loop(*bus, desk, tally);
  signals.set([&loop] { loop.drain(); });
  loop.run();
  signals.set(nullptr);
  return bus->misdeeds > 0 ? 0 : 3;
}

}  // namespace
}  // namespace accord::testing

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: crooked_worker lie|repeat [flags of accord-worker]\n";
    return 2;
  }
  return accord::testing::run(argv[1], argc - 1, argv + 1);
}
