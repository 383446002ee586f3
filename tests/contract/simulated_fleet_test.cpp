// The simulated public topics keep the contract, and wrong ones do not; faults come as ordered, the
// same for the same seed, and plans come through all of them.
#include "common/transport/fleet/simulated_fleet.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/contract/fleet_contract.h"
#include "tests/contract/fleet_samples.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using fleet_contract::Check;
using fleet_samples::bits_of;
using fleet_samples::plan_of;

class SimulatedFleetWorld : public fleet_contract::World {
 public:
  std::unique_ptr<FleetServicePort> serve(std::function<void()> wake) override {
    return fleet_.serve(std::move(wake));
  }
  std::unique_ptr<FleetClientPort> join() override { return fleet_.join(); }

 private:
  SimulatedFleet fleet_{1, 20ms};
};

class SimulatedFleetPorts : public testing::TestWithParam<Check> {};

TEST_P(SimulatedFleetPorts, KeepTheContract) {
  SimulatedFleetWorld world;
  EXPECT_EQ(GetParam().run(world), "");
}

INSTANTIATE_TEST_SUITE_P(Contract, SimulatedFleetPorts, testing::ValuesIn(fleet_contract::checks()),
                         [](const auto& param_info) { return param_info.param.name; });

// ---- Wrong ones ----

// Pass everything on, but for what a wrong one does otherwise.
struct WrongService : FleetServicePort {
  explicit WrongService(std::unique_ptr<FleetServicePort> port) : right(std::move(port)) {}
  std::optional<FleetRequest> take() override { return right->take(); }
  void publish(const FleetNews& news) override { right->publish(news); }
  const FleetCounters& counters() const override { return right->counters(); }
  std::unique_ptr<FleetServicePort> right;
};

struct WrongClient : FleetClientPort {
  explicit WrongClient(std::unique_ptr<FleetClientPort> port) : right(std::move(port)) {}
  bool send(const FleetRequest& request) override { return right->send(request); }
  std::optional<FleetNews> take() override { return right->take(); }
  void wait(std::chrono::nanoseconds timeout) override { right->wait(timeout); }
  bool has_service() const override { return right->has_service(); }
  const FleetCounters& counters() const override { return right->counters(); }
  std::unique_ptr<FleetClientPort> right;
};

struct LosingService : WrongService {
  using WrongService::WrongService;
  std::optional<FleetRequest> take() override {
    return ++count % 7 == 0 ? right->take(), right->take() : right->take();
  }
  int count = 0;
};

struct ChangingService : WrongService {
  using WrongService::WrongService;
  std::optional<FleetRequest> take() override {
    auto request = right->take();
    if (!request) return request;
    auto* plan = std::get_if<PlanRequest>(&*request);
    if (plan != nullptr && !plan->attachments.empty()) plan->attachments[0].content.back() ^= 1;
    return request;
  }
};

// As a float on the wire would.
struct RoundingService : WrongService {
  using WrongService::WrongService;
  void publish(const FleetNews& news) override {
    FleetNews rounded = news;
    if (auto* plan = std::get_if<FinishedPlan>(&rounded)) {
      for (auto& [name, value] : plan->plan.statistics) value = static_cast<float>(value);
    }
    right->publish(rounded);
  }
};

struct DuplicatingClient : WrongClient {
  using WrongClient::WrongClient;
  std::optional<FleetNews> take() override {
    if (held) return std::exchange(held, std::nullopt);
    held = right->take();
    return held;
  }
  std::optional<FleetNews> held;
};

struct TrustingClient : WrongClient {
  using WrongClient::WrongClient;
  bool send(const FleetRequest& request) override { return right->send(request), true; }
};

// Gives everything that ever comes, whoever asked for it.
struct ForgetfulClient : WrongClient {
  using WrongClient::WrongClient;
  std::optional<FleetNews> take() override {
    auto news = right->take();
    if (news && std::holds_alternative<FinishedPlan>(*news)) plan = news;
    if (!news && plan) return std::exchange(plan, std::nullopt);
    return news;
  }
  std::optional<FleetNews> plan;
};

template <typename Service, typename Client>
class WrongWorld final : public SimulatedFleetWorld {
 public:
  std::unique_ptr<FleetServicePort> serve(std::function<void()> wake) override {
    return std::make_unique<Service>(SimulatedFleetWorld::serve(std::move(wake)));
  }
  std::unique_ptr<FleetClientPort> join() override {
    return std::make_unique<Client>(SimulatedFleetWorld::join());
  }
};

template <typename Service, typename Client>
std::string breach(const std::string& check) {
  WrongWorld<Service, Client> world;
  return fleet_contract::check_named(check).run(world);
}

TEST(WrongFleetPorts, AreToldFromRightOnes) {
  EXPECT_EQ((breach<WrongService, WrongClient>("RequestsArriveAsTheyWere")), "");
  EXPECT_NE((breach<ChangingService, WrongClient>("RequestsArriveAsTheyWere")), "");
  EXPECT_NE((breach<ChangingService, WrongClient>("ALargeSceneArrivesWhole")), "");
  EXPECT_NE((breach<LosingService, WrongClient>("EveryRequestOfABurstArrives")), "");
  EXPECT_NE((breach<RoundingService, WrongClient>("APlanOfAThousandRobotsArrivesToTheBit")), "");
  EXPECT_NE((breach<WrongService, DuplicatingClient>("EveryKindOfNewsArrivesAsItWas")), "");
  EXPECT_NE((breach<WrongService, TrustingClient>("NothingIsSentWhereNoServiceIs")), "");
  EXPECT_NE((breach<WrongService, ForgetfulClient>("ManyPlansArriveOnceEach")), "");
}

// ---- Faults ----

class FleetFaultsTest : public testing::Test {
 protected:
  // How many of so many states come.
  std::size_t received_of(std::uint32_t count) {
    RequestState state;
    for (state.ahead = 0; state.ahead < count; ++state.ahead) service_->publish(state);
    states_.clear();
    while (auto news = client_->take()) states_.push_back(std::get<RequestState>(*news).ahead);
    return states_.size();
  }

  SimulatedFleet fleet_{5, 2ms};
  std::unique_ptr<FleetServicePort> service_ = fleet_.serve([] {});
  std::unique_ptr<FleetClientPort> client_ = fleet_.join();
  std::vector<std::uint32_t> states_;
};

TEST_F(FleetFaultsTest, ComeAboutAsOftenAsOrdered) {
  fleet_.set_faults({.drop = 0.3});
  EXPECT_NEAR(static_cast<double>(received_of(2000)), 1400, 100);
  EXPECT_TRUE(std::ranges::is_sorted(states_));
  fleet_.set_faults({.duplicate = 0.3});
  EXPECT_NEAR(static_cast<double>(received_of(2000)), 2600, 100);
  fleet_.set_faults({.reorder = 0.3});
  EXPECT_EQ(received_of(2000), 2000);
  EXPECT_FALSE(std::ranges::is_sorted(states_));
}

TEST_F(FleetFaultsTest, AreTheSameForTheSameSeed) {
  const auto run = [](std::uint64_t seed) {
    SimulatedFleet fleet(seed);
    const auto service = fleet.serve([] {});
    const auto client = fleet.join();
    fleet.set_faults({.drop = 0.2, .duplicate = 0.2, .reorder = 0.2});
    RequestState state;
    for (state.ahead = 0; state.ahead < 60; ++state.ahead) service->publish(state);
    std::vector<std::uint32_t> out;
    while (auto news = client->take()) out.push_back(std::get<RequestState>(*news).ahead);
    return out;
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

TEST_F(FleetFaultsTest, OfAnyKindDoNotKeepPlansFromWhoAsks) {
  fleet_.set_faults({.drop = 0.02, .duplicate = 0.3, .reorder = 0.3});
  const FinishedPlan plan = plan_of("1", 50, 30);
  ASSERT_TRUE(client_->send(ResendRequest{plan.id}));
  service_->publish(plan);
  std::optional<FleetNews> news;
  const auto end = std::chrono::steady_clock::now() + 20s;
  while (!news && std::chrono::steady_clock::now() < end) {
    while (const auto request = service_->take()) service_->publish(plan);
    client_->wait(1ms);
    news = client_->take();
  }
  ASSERT_TRUE(news);
  EXPECT_EQ(bits_of(std::get<FinishedPlan>(*news).plan), bits_of(plan.plan));
}

TEST_F(FleetFaultsTest, OfAKilledServiceEndWhenItComesBack) {
  ASSERT_TRUE(client_->send(CancelRequest{"1"}));
  fleet_.kill_service();
  EXPECT_FALSE(service_->take());
  service_->publish(RequestState{});
  EXPECT_EQ(service_->counters().unsent, 1);
  EXPECT_FALSE(client_->has_service());
  EXPECT_FALSE(client_->send(CancelRequest{"2"}));
  int wakes = 0;
  const auto next = fleet_.serve([&] { ++wakes; });
  service_.reset();  // of the life before: no matter to this one
  EXPECT_TRUE(client_->has_service());
  EXPECT_FALSE(next->take());
  EXPECT_TRUE(client_->send(CancelRequest{"3"}));
  EXPECT_EQ(wakes, 1);
  EXPECT_EQ(next->take(), FleetRequest(CancelRequest{"3"}));
  EXPECT_FALSE(client_->take());
}

}  // namespace
}  // namespace accord
