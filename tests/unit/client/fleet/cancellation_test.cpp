#include "client/fleet/cancellation.h"

#include <gtest/gtest.h>

#include "common/transport/fleet/simulated_fleet.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using Clock = Cancellation::Clock;

FleetManager::Settings quick() {
  FleetManager::Settings settings;
  settings.again = 5ms;
  settings.at_most = 40ms;
  return settings;
}

class CancellationTest : public ::testing::Test {
 protected:
  // The next end, while the service answers each cancel.
  template <typename Answer>
  Cancellation::End next(Cancellation& cancellation, const Answer& answer) {
    const auto give_up = Clock::now() + 30s;
    while (Clock::now() < give_up) {
      if (auto end = cancellation.next(1ms)) return *end;
      while (const auto request = service_->take()) {
        answer(std::get<CancelRequest>(*request).id);
      }
    }
    throw std::runtime_error("it waits forever");
  }
  void say_plan(const std::string& id, PlanStatus status) {
    FinishedPlan finished{id, {}};
    finished.plan.status = status;
    finished.plan.message = "why";
    if (status == PlanStatus::kSolved) finished.plan.robots.resize(1);
    for (RobotPlan& robot : finished.plan.robots) {
      robot.name = "r";
      robot.trajectory = Trajectory(1);
      robot.trajectory.append(0, Configuration{1.0});
    }
    service_->publish(finished);
  }

  SimulatedFleet fleet_{1};
  std::unique_ptr<FleetServicePort> service_ = fleet_.serve([] {});
  std::unique_ptr<FleetClientPort> port_ = fleet_.join(HeardPlans::kOutcomes);
};

TEST_F(CancellationTest, TellsHowEachRequestEnded) {
  Cancellation cancellation(*port_, {"a", "b", "c"}, quick());
  std::map<std::string, Cancellation::End> ends;
  while (cancellation.is_waiting()) {
    auto end = next(cancellation, [this](const std::string& id) {
      if (id == "a") say_plan(id, PlanStatus::kCancelled);
      if (id == "b") say_plan(id, PlanStatus::kSolved);
      if (id == "c") service_->publish(RequestReply{id, false, Rejection::kUnknownRequest, "", ""});
    });
    EXPECT_TRUE(ends.emplace(end.id, end).second) << "each once";
  }
  EXPECT_EQ(std::get<Plan>(ends.at("a").how).status, PlanStatus::kCancelled);
  EXPECT_EQ(std::get<Plan>(ends.at("b").how).status, PlanStatus::kSolved);
  EXPECT_EQ(std::get<NoAnswer>(ends.at("c").how).reply.reason, Rejection::kUnknownRequest);
}

TEST_F(CancellationTest, AsksUntilItIsToldWhateverGetsLost) {
  fleet_.set_faults({0.5, 0.2, 0.2});
  Cancellation cancellation(*port_, {"a"}, quick());
  int asked = 0;
  const auto end = next(cancellation, [&](const std::string& id) {
    if (++asked > 3) say_plan(id, PlanStatus::kCancelled);
  });
  EXPECT_EQ(std::get<Plan>(end.how).status, PlanStatus::kCancelled);
}

TEST_F(CancellationTest, IsNotEndedByAReplyToWhatOthersAsk) {
  Cancellation cancellation(*port_, {"a"}, quick());
  int asked = 0;
  const auto end = next(cancellation, [&](const std::string& id) {
    service_->publish(RequestReply{id, true, Rejection::kNone, "", ""});
    service_->publish(RequestReply{id, false, Rejection::kShuttingDown, "", ""});
    say_plan("another", PlanStatus::kSolved);
    if (++asked > 2) say_plan(id, PlanStatus::kCancelled);
  });
  EXPECT_EQ(end.id, "a");
  EXPECT_TRUE(std::holds_alternative<Plan>(end.how));
}

TEST_F(CancellationTest, WaitsForTheNextServiceButNotForever) {
  FleetManager::Settings settings = quick();
  settings.patience = 300ms;
  fleet_.kill_service();
  Cancellation cancellation(*port_, {"a", "b"}, settings);
  EXPECT_FALSE(cancellation.next(20ms));
  service_ = fleet_.serve([] {});
  const auto end = next(cancellation, [this](const std::string& id) {
    if (id == "a") say_plan(id, PlanStatus::kCancelled);
  });
  EXPECT_EQ(end.id, "a");
  fleet_.kill_service();
  const auto last = cancellation.next(10s);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->id, "b");
  EXPECT_EQ(std::get<NoAnswer>(last->how).why, NoAnswer::Why::kNoService);
  EXPECT_FALSE(cancellation.is_waiting());
}

}  // namespace
}  // namespace accord
