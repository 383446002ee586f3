// The simulated network keeps the contract of Bus, and wrong ones do not; faults and failures come
// as ordered, the same for the same seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "common/transport/simulated_network.h"
#include "tests/contract/bus_contract.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using bus_contract::Check;

class SimulatedWorld final : public bus_contract::World {
 public:
  std::unique_ptr<Bus> join(Role role, std::uint32_t protocol) override {
    return network_.join(role, protocol);
  }

 private:
  SimulatedNetwork network_{1};
};

class SimulatedBus : public testing::TestWithParam<Check> {};

TEST_P(SimulatedBus, KeepsTheContract) {
  SimulatedWorld world;
  EXPECT_EQ(GetParam().run(world), "");
}

INSTANTIATE_TEST_SUITE_P(Contract, SimulatedBus, testing::ValuesIn(bus_contract::checks()),
                         [](const auto& param_info) { return param_info.param.name; });

// ---- Wrong ones ----

// Passes everything on, but for what a wrong one does otherwise.
class WrongBus : public Bus {
 public:
  explicit WrongBus(std::unique_ptr<Bus> right)
      : Bus(right->self(), right->role()), right_(std::move(right)) {}

 protected:
  Published do_publish(EndpointId to, const Message& message) override {
    return right_->publish(to, message);
  }
  std::optional<BusEvent> do_take() override { return right_->take(); }
  bool do_wait(Duration timeout) override { return right_->wait_for_event(timeout); }
  void do_wake() override { right_->wake(); }

  std::unique_ptr<Bus> right_;
};

struct Duplicating : WrongBus {
  using WrongBus::WrongBus;
  Published do_publish(EndpointId to, const Message& message) override {
    right_->publish(to, message);
    return right_->publish(to, message);
  }
};

struct Losing : WrongBus {
  using WrongBus::WrongBus;
  Published do_publish(EndpointId to, const Message& message) override {
    return ++count % 7 == 0 ? Published::kSent : right_->publish(to, message);
  }
  int count = 0;
};

struct Reordering : WrongBus {
  using WrongBus::WrongBus;
  std::optional<BusEvent> do_take() override {
    while (auto event = right_->take()) held.push_back(std::move(*event));
    if (held.empty()) return std::nullopt;
    BusEvent last = std::move(held.back());
    held.pop_back();
    return last;
  }
  std::deque<BusEvent> held;
};

struct Broadcasting : WrongBus {
  using WrongBus::WrongBus;
  Published do_publish(EndpointId, const Message& message) override {
    for (const EndpointId peer : right_->peers()) right_->publish(peer, message);
    return Published::kSent;
  }
};

struct Boundless : WrongBus {
  using WrongBus::WrongBus;
  Published do_publish(EndpointId to, const Message& message) override {
    right_->publish(to, message);
    return Published::kSent;
  }
};

struct Changing : WrongBus {
  using WrongBus::WrongBus;
  Published do_publish(EndpointId to, const Message& message) override {
    Message changed = message;
    if (auto* piece = std::get_if<ScenePiece>(&changed)) piece->data.back() ^= 1U;
    return right_->publish(to, changed);
  }
};

struct Blind : WrongBus {
  using WrongBus::WrongBus;
  std::optional<BusEvent> do_take() override {
    auto event = right_->take();
    if (event && std::holds_alternative<PeerLost>(event->what)) return right_->take();
    return event;
  }
};

template <typename Wrong>
class WrongWorld final : public bus_contract::World {
 public:
  std::unique_ptr<Bus> join(Role role, std::uint32_t protocol) override {
    return std::make_unique<Wrong>(network_.join(role, protocol));
  }

 private:
  SimulatedNetwork network_{1};
};

template <typename Wrong>
std::string breach(const std::string& check) {
  WrongWorld<Wrong> world;
  return bus_contract::check_named(check).run(world);
}

TEST(WrongBuses, AreToldFromRightOnes) {
  EXPECT_EQ(breach<WrongBus>("EveryKindArrivesAsItWas"), "");
  EXPECT_NE(breach<Duplicating>("EveryKindArrivesAsItWas"), "");
  EXPECT_NE(breach<Changing>("EveryKindArrivesAsItWas"), "");
  EXPECT_NE(breach<Changing>("ASceneArrivesInPieces"), "");
  EXPECT_NE(breach<Losing>("MessagesOfAKindKeepTheirOrder"), "");
  EXPECT_NE(breach<Reordering>("MessagesOfAKindKeepTheirOrder"), "");
  EXPECT_NE(breach<Broadcasting>("OnlyWhoIsAddressedReceives"), "");
  EXPECT_NE(breach<Boundless>("WhoDoesNotTakeIsNotSentMore"), "");
  EXPECT_NE(breach<Blind>("WhoLeavesIsLost"), "");
}

// ---- Faults ----

class Faults : public testing::Test {
 protected:
  void meet() {
    network_.advance_to(network_.now() + 1s);
    take_all();
  }

  // Their numbers, as they come.
  std::vector<std::uint32_t> take_all() {
    std::vector<std::uint32_t> out;
    while (auto event = coordinator_->take()) {
      if (const auto* message = std::get_if<Message>(&event->what)) {
        out.push_back(std::get<Heartbeat>(*message).idle_threads);
      }
    }
    while (worker_->take()) {
    }
    return out;
  }

  std::vector<std::uint32_t> send(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      EXPECT_EQ(worker_->publish(coordinator_->self(), Heartbeat{i, {}}), Published::kSent);
    }
    network_.advance_to(network_.now() + 1s);
    return take_all();
  }

  SimulatedNetwork network_{5};
  std::unique_ptr<Bus> coordinator_ = network_.join(Role::kCoordinator, kProtocol, 10'000);
  std::unique_ptr<Bus> worker_ = network_.join(Role::kWorker, kProtocol, 10'000);
};

TEST_F(Faults, DropAboutAsManyAsOrdered) {
  meet();
  network_.set_faults({.drop = 0.3});
  const auto received = send(2000);
  EXPECT_NEAR(static_cast<double>(received.size()), 1400, 100);
  EXPECT_TRUE(std::ranges::is_sorted(received));
}

TEST_F(Faults, DuplicateAboutAsManyAsOrdered) {
  meet();
  network_.set_faults({.duplicate = 0.3});
  EXPECT_NEAR(static_cast<double>(send(2000).size()), 2600, 100);
}

TEST_F(Faults, ReorderWithoutLosingAny) {
  meet();
  network_.set_faults({.reorder = 0.3});
  auto received = send(2000);
  EXPECT_EQ(received.size(), 2000);
  EXPECT_FALSE(std::ranges::is_sorted(received));
  std::ranges::sort(received);
  EXPECT_EQ(received.back(), 1999);
}

TEST_F(Faults, AreTheSameForTheSameSeed) {
  const auto run = [](std::uint64_t seed) {
    SimulatedNetwork network(seed);
    const auto coordinator = network.join(Role::kCoordinator);
    const auto worker = network.join(Role::kWorker);
    network.set_faults({.drop = 0.2, .duplicate = 0.2, .reorder = 0.2});
    network.advance_to(1s);
    while (worker->take()) {
    }
    for (std::uint32_t i = 0; i < 60; ++i) {
      worker->publish(coordinator->self(), Heartbeat{i, {}});
    }
    network.advance_to(2s);
    std::vector<std::uint32_t> out;
    while (auto event = coordinator->take()) {
      const auto* message = std::get_if<Message>(&event->what);
      if (message != nullptr) out.push_back(std::get<Heartbeat>(*message).idle_threads);
    }
    return out;
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

TEST_F(Faults, OfACutLinkHoldMessagesUntilItHeals) {
  meet();
  network_.cut(coordinator_->self(), worker_->self());
  EXPECT_TRUE(send(5).empty());
  network_.heal(coordinator_->self(), worker_->self());
  network_.advance_to(network_.now() + 1s);
  EXPECT_EQ(take_all().size(), 5);
  EXPECT_TRUE(coordinator_->is_present(worker_->self()));
}

TEST_F(Faults, OfALinkCutForLongLoseThePeerAndWhatWasSentToIt) {
  meet();
  network_.cut(coordinator_->self(), worker_->self());
  EXPECT_TRUE(send(5).empty());
  network_.advance_to(network_.now() + 5s);
  take_all();
  EXPECT_FALSE(coordinator_->is_present(worker_->self()));
  EXPECT_FALSE(worker_->is_present(coordinator_->self()));
  network_.heal(worker_->self(), coordinator_->self());
  meet();
  EXPECT_TRUE(coordinator_->is_present(worker_->self()));
  EXPECT_EQ(send(3), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST_F(Faults, OfAKilledProcessShowWhenItsLeaseEnds) {
  meet();
  network_.kill(worker_->self());
  EXPECT_EQ(worker_->publish(coordinator_->self(), Heartbeat{}), Published::kClosed);
  network_.advance_to(network_.now() + 1900ms);
  take_all();
  EXPECT_TRUE(coordinator_->is_present(worker_->self()));
  network_.advance_to(network_.now() + 200ms);
  take_all();
  EXPECT_FALSE(coordinator_->is_present(worker_->self()));
}

TEST_F(Faults, OfAFrozenProcessEndWhenItThaws) {
  meet();
  network_.freeze(worker_->self());
  network_.advance_to(network_.now() + 3s);
  take_all();
  EXPECT_FALSE(coordinator_->is_present(worker_->self()));
  network_.thaw(worker_->self());
  // What it says before anybody has found it again is late, but it comes.
  EXPECT_EQ(send(1).size(), 1);
  EXPECT_TRUE(coordinator_->is_present(worker_->self()));
}

TEST_F(Faults, AreSimulatedByTheHundredThousand) {
  meet();
  for (int i = 0; i < 20; ++i) ASSERT_EQ(send(5'000).size(), 5'000);
}

TEST(SimulatedLink, TakesAsLongAsItsRateAsks) {
  NetworkTimes times;
  times.bytes_per_second = 1e6;
  SimulatedNetwork network(1, times);
  const auto coordinator = network.join(Role::kCoordinator);
  const auto worker = network.join(Role::kWorker);
  network.advance_to(1s);
  while (coordinator->take()) {
  }
  for (int i = 0; i < 10; ++i) {
    const ScenePiece piece{{}, 1'000'000, 0, Bytes(100'000)};
    ASSERT_EQ(coordinator->publish(worker->self(), piece), Published::kSent);
  }
  std::size_t received = 0;
  while (received < 10) {
    ASSERT_TRUE(worker->wait_for_event(10s));
    while (auto event = worker->take()) {
      if (std::holds_alternative<Message>(event->what)) ++received;
    }
  }
  EXPECT_NEAR(std::chrono::duration<double>(network.now()).count(), 2, 0.01);
}

}  // namespace
}  // namespace accord
