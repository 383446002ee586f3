// Whole requests, on a service that suffers: its coordinator is killed between any two things that
// it does, or asked to end; its workers die, hang and lie; its journal cannot be written for a
// while; fleet managers submit, submit again, ask and cancel, and part of what is said gets lost.
// What was accepted ends once, as on a quiet day.
//
// ACCORD_CLUSTERS: how many services, each from a seed; 150 unless told (the campaign: 1000).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "client/engine/planner.h"
#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/plan_file.h"
#include "common/io/scene_file.h"
#include "coordinator/journal/memory_journal.h"
#include "tests/simulation/service_witness.h"
#include "tests/simulation/simulated_coordinator.h"

namespace accord {
namespace {

using std::chrono::milliseconds;
using testing::Killed;
using testing::ServiceWitness;
using testing::SimulatedCoordinator;
using Time = Bus::Duration;

constexpr int kStrikes = 60;
constexpr auto kStuck = std::chrono::minutes(10);
constexpr std::size_t kOrders = 4;

// What may be asked for, and what is planned of it in one process.
struct Dish {
  std::string scene_text;
  std::uint64_t seed;
  std::string plan;  // canonical bytes
};

std::vector<Dish> make_menu() {
  std::vector<Dish> menu;
  for (const char* scene :
       {"peer-inlet", "peer-parallel-008", "low-mobile-08", "adaptive-mobile"}) {
    const std::string path = std::string(ACCORD_SOURCE_DIR "/scenes/") + scene + ".yaml";
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      PlanOptions options;
      options.seed = seed;
      menu.push_back({*read_file(path, limits::kSceneBytes), seed,
                      canonical_bytes(plan(load_scene(path).scene, options))});
    }
  }
  return menu;
}

// One service and its fleet managers, from a seed.
class Ordeal final : public testing::CoordinatorWatcher {
 public:
  Ordeal(std::uint64_t seed, const std::vector<Dish>& menu, testing::SolvedJobs& solved)
      : random_(seed),
        cluster_(seed, &solved),
        fleet_(seed, std::chrono::hours(1)),
        client_(fleet_.join()) {
    for (int i = 0; i < 3; ++i) cluster_.start_worker();
    for (std::size_t i = 0; i < kOrders; ++i) {
      const std::size_t choice = random_.below(menu.size());
      Order& order = orders_["order-" + std::to_string(i)];
      order.request = request(i, menu[choice]);
      order.rival = request(i, menu[(choice + 1) % menu.size()]);
    }
  }

  void run() {
    while (!is_over()) {
      live();
      const Time back_at = cluster_.now() + milliseconds(random_.below(1500));
      while (cluster_.now() < back_at) cluster_.pass(back_at);
    }
    for (const auto& [id, order] : orders_) witness_.check_kept(id, *order.outcome);
  }

  const ServiceWitness& witness() const { return witness_; }
  std::size_t lives() const { return lives_; }
  std::size_t kills() const { return kills_; }

 private:
  struct Order {
    PlanRequest request;
    PlanRequest rival;                   // other content under the same id
    bool is_known = false;               // to the service, with the one content or the other
    std::optional<std::string> outcome;  // canonical bytes, as heard last
  };

  PlanRequest request(std::size_t order, const Dish& dish) {
    PlanRequest request;
    request.id = "order-" + std::to_string(order);
    request.scene_text = dish.scene_text;
    request.seed = dish.seed;
    witness_.expect(request, dish.plan);
    return request;
  }

  void live() {
    ++lives_;
    steps_left_.reset();
    SimulatedCoordinator coordinator(cluster_, fleet_, journal_, *this, random_.next());
    coordinator_ = &coordinator;
    witness_.on_begun();
    try {
      while (!is_over() && !coordinator.is_done()) coordinator.work();
    } catch (const Killed&) {
      ++kills_;
      cluster_.network().kill(coordinator.id());
      fleet_.kill_service();
    }
    coordinator_ = nullptr;
  }
  bool is_over() const {
    if (strikes_ < kStrikes || !journal_.unfinished()->empty()) return false;
    if (coordinator_ != nullptr && !coordinator_->is_idle()) return false;
    return std::ranges::all_of(orders_,
                               [](const auto& order) { return order.second.outcome.has_value(); });
  }

  // ---- CoordinatorWatcher ----

  void at_turn() override {
    EXPECT_LT(cluster_.now(), kStuck) << "stuck";
    if (cluster_.now() >= kStuck) throw std::runtime_error("stuck");
    while (const auto news = client_->take()) hear(*news);
    if (cluster_.now() >= strike_at_) {
      strikes_ < kStrikes ? strike() : insist();
      strike_at_ = cluster_.now() + milliseconds(strikes_ < kStrikes ? random_.below(60) : 500);
    }
    at_step();
  }
  void at_step() override {
    if (steps_left_ && (*steps_left_)-- == 0) throw Killed{};
  }
  void on_taken(const FleetRequest& request) override { witness_.on_taken(request); }
  void on_said(const FleetNews& news) override { witness_.on_said(news); }
  void on_written(const RequestDesk::Accept& work, const std::string& fault) override {
    witness_.on_written(work, fault);
    at_step();
  }
  void on_written(const RequestDesk::Finish& work, const std::string& fault) override {
    witness_.on_written(work, fault);
    at_step();
  }

  // ---- Fleet managers ----

  void hear(const FleetNews& news) {
    if (const auto* reply = std::get_if<RequestReply>(&news)) {
      const auto order = orders_.find(reply->id);
      if (order == orders_.end()) return;
      if (reply->accepted || reply->reason == Rejection::kIdInUse) order->second.is_known = true;
      if (reply->reason == Rejection::kUnknownRequest) order->second.is_known = false;
    } else if (const auto* finished = std::get_if<FinishedPlan>(&news)) {
      orders_.at(finished->id).outcome = canonical_bytes(finished->plan);
    }
  }

  Order& any_order() {
    return std::next(orders_.begin(), static_cast<std::ptrdiff_t>(random_.below(kOrders)))->second;
  }

  void strike() {
    ++strikes_;
    switch (random_.below(20)) {
      case 0:
        steps_left_ = random_.below(60);
        break;
      case 1:
        coordinator_->drain();
        break;
      case 2:
        journal_.fail_next_writes(1 + random_.below(4));
        break;
      case 3:
        fleet_.set_faults({0.1 * static_cast<double>(random_.below(4)), 0.1, 0.3});
        break;
      case 4:
        fleet_.set_faults({});
        break;
      case 5:
      case 6:
      case 7:
        client_->send(any_order().request);
        break;
      case 8:
        client_->send(any_order().rival);
        break;
      case 9:
        client_->send(ResendRequest{any_order().request.id});
        break;
      case 10:
        if (random_.below(3) == 0) client_->send(CancelRequest{any_order().request.id});
        break;
      case 11: {
        PlanRequest nonsense;
        nonsense.id = "nonsense";
        nonsense.scene_text = "robots: 5";
        client_->send(nonsense);
        break;
      }
      default:
        cluster_.strike(coordinator_->id());
    }
  }

  // In the end it gets quiet, and whoever has no answer asks for it.
  void insist() {
    if (!std::exchange(is_quiet_, true)) {
      journal_.fail_next_writes(0);
      fleet_.set_faults({});
      cluster_.start_worker();
    }
    cluster_.calm(coordinator_->id());
    for (auto& [id, order] : orders_) {
      if (order.outcome) continue;
      order.is_known ? client_->send(ResendRequest{id}) : client_->send(order.request);
    }
  }

  RandomStream random_;
  testing::SimulatedCluster cluster_;
  SimulatedFleet fleet_;
  std::unique_ptr<FleetClientPort> client_;
  MemoryJournal journal_;
  ServiceWitness witness_{journal_};
  std::map<std::string, Order> orders_;
  SimulatedCoordinator* coordinator_ = nullptr;
  std::optional<std::size_t> steps_left_;  // of the coordinator's life
  Time strike_at_{0};
  int strikes_ = 0;
  bool is_quiet_ = false;
  std::size_t lives_ = 0, kills_ = 0;
};

TEST(SufferingService, LosesNothingAndEndsEveryRequestOnceAsOnAQuietDay) {
  const char* told = std::getenv("ACCORD_CLUSTERS");
  const std::uint64_t services = told != nullptr ? std::strtoull(told, nullptr, 10) : 150;
  const std::vector<Dish> menu = make_menu();
  testing::SolvedJobs solved;
  std::size_t kills = 0, lives = 0, given_up = 0, cancelled = 0;
  std::map<Rejection, std::size_t> refusals;
  for (std::uint64_t seed = 1; seed <= services; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Ordeal ordeal(seed, menu, solved);
    ordeal.run();
    if (HasFailure()) return;
    kills += ordeal.kills();
    lives += ordeal.lives();
    given_up += ordeal.witness().given_up();
    cancelled += ordeal.witness().cancelled();
    for (const auto& [reason, count] : ordeal.witness().refusals()) refusals[reason] += count;
  }
  EXPECT_GT(kills, services) << "coordinators hardly died";
  EXPECT_GT(lives, kills + services) << "hardly any was asked to end";
  EXPECT_GT(cancelled, services / 10);
  EXPECT_LE(given_up, services * kOrders / 20);
  for (const Rejection reason :
       {Rejection::kIdInUse, Rejection::kBadScene, Rejection::kQueueFull, Rejection::kNoJournal,
        Rejection::kShuttingDown, Rejection::kUnknownRequest}) {
    EXPECT_GT(refusals[reason], 0U) << to_string(reason) << " never came up";
  }
}

}  // namespace
}  // namespace accord
