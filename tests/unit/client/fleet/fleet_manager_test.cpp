#include "client/fleet/fleet_manager.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "common/transport/fleet/simulated_fleet.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using Clock = FleetManager::Clock;

FleetManager::Settings quick() {
  FleetManager::Settings settings;
  settings.patience = 10s;
  settings.again = 5ms;
  settings.at_most = 40ms;
  return settings;
}

PlanRequest request_of(const std::string& id) {
  PlanRequest request;
  request.id = id;
  request.scene_text = "the scene of " + id;
  return request;
}

Plan plan_of(const std::string& id, PlanStatus status = PlanStatus::kSolved) {
  Plan plan;
  plan.scene = "the scene of " + id;
  plan.status = status;
  if (status != PlanStatus::kSolved) {
    plan.message = "cancelled";
    return plan;
  }
  for (const char* name : {"r0", "r1"}) {
    RobotPlan robot;
    robot.name = name;
    robot.trajectory = Trajectory(2);
    for (int i = 0; i < 5; ++i) robot.trajectory.append(i, Configuration{1.0 * i, 2});
    robot.segments = {{0, 4, {name}, "prm"}};
    plan.robots.push_back(std::move(robot));
  }
  return plan;
}

// A service on a thread of its own that does as it is told, and remembers what it was asked in this
// life.
class ScriptedService {
 public:
  explicit ScriptedService(SimulatedFleet& fleet)
      : port_(fleet.serve([] {})), thread_([this] { serve(); }) {}
  ~ScriptedService() {
    quit_ = true;
    thread_.join();
  }
  ScriptedService(const ScriptedService&) = delete;
  ScriptedService& operator=(const ScriptedService&) = delete;

  std::atomic<bool> finishes = true;      // what it has accepted
  std::atomic<bool> answers = true;       // anything at all
  std::atomic<bool> is_ending = false;    // it takes nothing more
  std::atomic<std::size_t> accepted = 0;  // requests, each counted once
  std::atomic<std::size_t> asked = 0;

 private:
  void serve() {
    while (!quit_) {
      while (const auto request = port_->take()) {
        ++asked;
        if (answers) std::visit([this](const auto& kind) { answer(kind); }, *request);
      }
      std::this_thread::sleep_for(200us);
    }
  }
  void answer(const PlanRequest& request) {
    if (request.id.starts_with("bad")) {
      port_->publish(RequestReply{request.id, false, Rejection::kBadScene, "robots", "no robots"});
      return;
    }
    if (is_ending) {
      port_->publish(RequestReply{request.id, false, Rejection::kShuttingDown, "", "about to end"});
      return;
    }
    if (known_.insert(request.id).second) ++accepted;
    stand(request.id);
  }
  void answer(const CancelRequest& request) {
    if (known_.contains(request.id)) cancelled_.insert(request.id);
    stand(request.id);
  }
  void answer(const ResendRequest& request) { stand(request.id); }
  void stand(const std::string& id) {
    if (!known_.contains(id)) {
      port_->publish(RequestReply{id, false, Rejection::kUnknownRequest, "request_id", "unknown"});
      return;
    }
    const bool is_cancelled = cancelled_.contains(id);
    const bool is_over = is_cancelled || finishes;
    RequestState state;
    state.id = id;
    state.phase = is_over ? RequestPhase::kFinished : RequestPhase::kConflicts;
    port_->publish(RequestReply{id, true, Rejection::kNone, "", ""});
    port_->publish(state);
    if (!is_over) return;
    port_->publish(
        FinishedPlan{id, plan_of(id, is_cancelled ? PlanStatus::kCancelled : PlanStatus::kSolved)});
  }

  std::unique_ptr<FleetServicePort> port_;
  std::set<std::string> known_, cancelled_;
  std::atomic<bool> quit_{false};
  std::thread thread_;
};

class FleetManagerTest : public ::testing::Test {
 protected:
  using Ends = std::map<std::string, std::vector<std::variant<RequestState, Plan, NoAnswer>>>;

  // How all that was submitted ended; each time that it did.
  const Ends& take_ends() {
    listen_until([&] { return !manager_->is_waiting(); });
    return ends_;
  }
  template <typename Condition>
  void listen_until(const Condition& condition) {
    const auto give_up = Clock::now() + 30s;
    while (!condition()) {
      ASSERT_LT(Clock::now(), give_up) << "it waits forever";
      auto event = manager_->next(1ms);
      if (!event || std::holds_alternative<RequestState>(event->what)) continue;
      ends_[event->id].push_back(std::move(event->what));
    }
  }

  SimulatedFleet fleet_{1, 20ms};
  std::unique_ptr<FleetClientPort> port_ = fleet_.join();
  std::optional<FleetManager> manager_{std::in_place, *port_, quick()};
  Ends ends_;
};

TEST_F(FleetManagerTest, EndsEveryRequestOnceWhateverGetsLost) {
  const ScriptedService service(fleet_);
  fleet_.set_faults({0.3, 0.2, 0.3});
  for (int i = 0; i < 30; ++i) manager_->submit(request_of(std::to_string(i)));
  const Ends& ends = take_ends();
  EXPECT_EQ(ends.size(), 30U);
  for (const auto& [id, how] : ends) {
    ASSERT_EQ(how.size(), 1U) << id;
    const auto* plan = std::get_if<Plan>(how.data());
    ASSERT_NE(plan, nullptr) << id;
    EXPECT_EQ(plan->scene, "the scene of " + id);
    EXPECT_EQ(plan->robots.size(), 2U);
  }
  EXPECT_EQ(service.accepted, 30U);
}

TEST_F(FleetManagerTest, SaysWhyARequestWasRejected) {
  const ScriptedService service(fleet_);
  manager_->submit(request_of("bad"));
  const Ends& ends = take_ends();
  const auto& end = std::get<NoAnswer>(ends.at("bad").at(0));
  EXPECT_EQ(end.why, NoAnswer::Why::kRejected);
  EXPECT_EQ(end.reply.reason, Rejection::kBadScene);
  EXPECT_EQ(end.reply.text, "no robots");
}

TEST_F(FleetManagerTest, GivesUpWhereThereIsNoService) {
  FleetManager::Settings settings = quick();
  settings.patience = 50ms;
  manager_.emplace(*port_, settings);
  manager_->submit(request_of("a"));
  const Ends& ends = take_ends();
  EXPECT_EQ(std::get<NoAnswer>(ends.at("a").at(0)).why, NoAnswer::Why::kNoService);
}

TEST_F(FleetManagerTest, WaitsForASilentServiceAsLongAsItTakesOnceItHasAccepted) {
  FleetManager::Settings settings = quick();
  settings.patience = 50ms;
  manager_.emplace(*port_, settings);
  ScriptedService service(fleet_);
  service.finishes = false;
  manager_->submit(request_of("a"));
  listen_until([&] { return service.accepted == 1; });
  manager_->next(20ms);  // the reply
  service.answers = false;
  const auto later = Clock::now() + 150ms;
  listen_until([&] { return Clock::now() > later; });
  EXPECT_TRUE(manager_->is_waiting());
  service.finishes = true;
  service.answers = true;
  EXPECT_TRUE(std::holds_alternative<Plan>(take_ends().at("a").at(0)));
}

TEST_F(FleetManagerTest, CancelsARequestWhateverGetsLost) {
  ScriptedService service(fleet_);
  service.finishes = false;
  fleet_.set_faults({0.3, 0.2, 0.3});
  manager_->submit(request_of("a"));
  manager_->submit(request_of("b"));
  listen_until([&] { return service.accepted == 2; });
  manager_->cancel("a");
  manager_->cancel("nobody's");
  listen_until([&] { return service.asked > 20; });
  service.finishes = true;
  const Ends& ends = take_ends();
  EXPECT_EQ(std::get<Plan>(ends.at("a").at(0)).status, PlanStatus::kCancelled);
  EXPECT_EQ(std::get<Plan>(ends.at("b").at(0)).status, PlanStatus::kSolved);
}

// Cancelled while the request itself may be on its way still: it is to end as cancelled all the
// same.
TEST_F(FleetManagerTest, CancelsARequestThatNobodyHasAnsweredYet) {
  manager_->submit(request_of("a"));
  manager_->next(1ms);
  manager_->cancel("a");
  ScriptedService service(fleet_);
  service.finishes = false;
  EXPECT_EQ(std::get<Plan>(take_ends().at("a").at(0)).status, PlanStatus::kCancelled);
}

TEST_F(FleetManagerTest, SubmitsAgainToAServiceThatHasForgottenEverything) {
  {
    ScriptedService service(fleet_);
    service.finishes = false;
    manager_->submit(request_of("a"));
    listen_until([&] { return service.accepted == 1; });
    manager_->next(20ms);  // the reply
    fleet_.kill_service();
  }
  manager_->next(20ms);
  const ScriptedService service(fleet_);
  EXPECT_TRUE(std::holds_alternative<Plan>(take_ends().at("a").at(0)));
  EXPECT_EQ(service.accepted, 1U);
}

TEST_F(FleetManagerTest, EndsEveryRequestOnceThroughManyLivesOfTheService) {
  for (int i = 0; i < 10; ++i) manager_->submit(request_of(std::to_string(i)));
  fleet_.set_faults({0.2, 0.2, 0.3});
  for (int life = 0; life < 5; ++life) {
    ScriptedService service(fleet_);
    service.finishes = life == 4;
    if (life == 4) take_ends();
    const auto end = Clock::now() + 20ms;
    listen_until([&] { return Clock::now() > end; });
    fleet_.kill_service();
  }
  EXPECT_EQ(ends_.size(), 10U);
  for (const auto& [id, how] : ends_) {
    ASSERT_EQ(how.size(), 1U) << id;
    EXPECT_TRUE(std::holds_alternative<Plan>(how[0])) << id;
  }
}

TEST_F(FleetManagerTest, PlansOneRequestAndSaysHowItComesAlong) {
  const ScriptedService service(fleet_);
  std::vector<RequestPhase> phases;
  const auto plan = manager_->plan(
      request_of("a"), [&](const RequestState& state) { phases.push_back(state.phase); },
      std::atomic<bool>{false});
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->scene, "the scene of a");
  EXPECT_THAT(phases, ::testing::Each(RequestPhase::kFinished));
  EXPECT_FALSE(phases.empty());
}

TEST_F(FleetManagerTest, CancelsTheOneRequestWhenItIsToStop) {
  ScriptedService service(fleet_);
  service.finishes = false;
  std::atomic<bool> stop{false};
  const auto plan = manager_->plan(
      request_of("a"), [&](const RequestState&) { stop = true; }, stop);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->status, PlanStatus::kCancelled);
}

TEST(FleetManager, SendsItsRequestWhateverItHearsOfAnEarlierOneOfThatId) {
  SimulatedFleet fleet(1);
  const auto service = fleet.serve([] {});
  const auto port = fleet.join();
  RequestState ended;
  ended.id = "a";
  ended.phase = RequestPhase::kFinished;
  service->publish(ended);  // as who joins late is told
  FleetManager manager(*port, quick());
  manager.submit(request_of("a"));
  EXPECT_FALSE(manager.next(50ms)) << "that is not its own news";
  const auto asked = service->take();
  ASSERT_TRUE(asked);
  EXPECT_TRUE(std::holds_alternative<PlanRequest>(*asked)) << "it has to be said what is wanted";
}

TEST(FleetManager, WaitsForTheServiceThatComesAfterOneThatIsAboutToEnd) {
  SimulatedFleet fleet(1);
  const auto port = fleet.join();
  FleetManager manager(*port, quick());
  std::optional<ScriptedService> service;
  service.emplace(fleet);
  service->is_ending = true;
  manager.submit(request_of("a"));
  EXPECT_FALSE(manager.next(100ms)) << "that is no end";
  EXPECT_GT(service->asked, 0U);
  service->is_ending = false;
  std::optional<Plan> plan;
  while (!plan) {
    auto event = manager.next(5s);
    ASSERT_TRUE(event);
    if (auto* found = std::get_if<Plan>(&event->what)) plan = std::move(*found);
  }
  EXPECT_EQ(plan->status, PlanStatus::kSolved);
}

}  // namespace
}  // namespace accord
