// What is beyond a limit is told from what is within, with a sentence.
#include "common/transport/fleet/fleet_limits.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/transport/fleet/plan_pieces.h"
#include "tests/contract/fleet_samples.h"

namespace accord {
namespace {

using Fault = std::optional<std::string>;

Fault request_fault(const auto& spoil) {
  PlanRequest request;
  spoil(request);
  return fleet_fault(FleetRequest(request));
}

Fault state_fault(const auto& spoil) {
  RequestState state;
  spoil(state);
  return fleet_fault(FleetNews(state));
}

Fault plan_fault(const auto& spoil) {
  FinishedPlan plan = fleet_samples::plan_of("1", 2, 3);
  spoil(plan.plan);
  return fleet_fault(FleetNews(plan));
}

Fault piece_fault(const auto& spoil) {
  const FinishedPlan plan = fleet_samples::plan_of("1", 2, 3);
  PathPiece piece = PlanPieces(plan).of_robot(0).front();
  spoil(piece);
  return fleet_fault(FleetPart(piece));
}

TEST(FleetLimits, LetPassWhatIsUsual) {
  for (const FleetRequest& request : fleet_samples::requests()) {
    EXPECT_EQ(fleet_fault(request), std::nullopt);
  }
  for (const FleetNews& news : fleet_samples::news()) EXPECT_EQ(fleet_fault(news), std::nullopt);
  EXPECT_EQ(plan_fault([](Plan&) {}), std::nullopt);
  EXPECT_EQ(piece_fault([](PathPiece&) {}), std::nullopt);
}

TEST(FleetLimits, AreKeptByRequests) {
  EXPECT_EQ(request_fault([](PlanRequest& r) { r.id.assign(kFleetIdBytes + 1, 'a'); }),
            "257 bytes of a request's id; expected at most 256");
  EXPECT_EQ(request_fault([](PlanRequest& r) { r.id.assign(3, '\0'); }),
            "a zero byte among the bytes of a request's id");
  EXPECT_EQ(request_fault([](PlanRequest& r) { r.scene_text.assign(limits::kSceneBytes, 'a'); }),
            std::nullopt);
  EXPECT_EQ(request_fault([](PlanRequest& r) { r.scene_text.assign(5 << 20U, 'a'); }),
            "5242880 bytes of a scene; expected at most 4194304");
  const std::string half(kAttachmentBytes / 2, '\0');
  EXPECT_EQ(request_fault([&](PlanRequest& r) {
              r.attachments = {{"a", half}, {"b", half}};
            }),
            std::nullopt);
  EXPECT_EQ(request_fault([&](PlanRequest& r) {
              r.attachments = {{"a", half}, {"b", half}, {"c", "1"}};
            }),
            "67108865 bytes of attachments; expected at most 67108864");
  EXPECT_TRUE(request_fault([](PlanRequest& r) { r.queries.resize(limits::kRobots + 1); }));
  EXPECT_TRUE(request_fault([](PlanRequest& r) {
    r.queries = {{"r", std::nullopt, Configuration(limits::kLinks + 1)}};
  }));
  EXPECT_TRUE(request_fault([](PlanRequest& r) { r.solvers.resize(limits::kSolvers + 1); }));
}

TEST(FleetLimits, AreKeptByStates) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(state_fault([](RequestState& s) { s.per_cent = 100; }), std::nullopt);
  EXPECT_EQ(state_fault([](RequestState& s) { s.per_cent = 100.5; }),
            "a state beyond 0 to 100 per cent");
  EXPECT_TRUE(state_fault([](RequestState& s) { s.per_cent = -1; }));
  EXPECT_TRUE(state_fault([&](RequestState& s) { s.per_cent = nan; }));
  EXPECT_TRUE(state_fault([&](RequestState& s) { s.elapsed = nan; }));
  EXPECT_TRUE(state_fault([&](RequestState& s) { s.best_cost = nan; }));
}

TEST(FleetLimits, AreKeptByPlans) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(plan_fault([](Plan& p) { p.robots.resize(limits::kRobots + 1); }));
  EXPECT_TRUE(plan_fault([](Plan& p) { p.statistics.resize(kStatistics + 1); }));
  EXPECT_TRUE(plan_fault([](Plan& p) { p.message.assign(kFleetTextBytes + 1, 'a'); }));
  EXPECT_EQ(plan_fault([](Plan& p) { p.robots[0].segments[0].robots = {"nobody"}; }),
            "a segment with a robot that the plan does not have");
  EXPECT_EQ(plan_fault([&](Plan& p) {
              p.robots[1].trajectory = Trajectory(1);
              p.robots[1].trajectory.append(0, Configuration{nan});
            }),
            "a path with a number that is not finite");
}

TEST(FleetLimits, AreKeptByPieces) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(piece_fault([](PathPiece& p) { p.piece = 1; }));
  EXPECT_TRUE(piece_fault([](PathPiece& p) { p.pieces = 0; }));
  EXPECT_TRUE(piece_fault([](PathPiece& p) { p.pieces = kPathPieces + 1; }));
  EXPECT_TRUE(piece_fault([](PathPiece& p) { p.robot_index = limits::kRobots; }));
  EXPECT_TRUE(piece_fault([](PathPiece& p) { p.configurations.pop_back(); }));
  EXPECT_TRUE(piece_fault([](PathPiece& p) { p.dof = 4'000'000'000; }));
  EXPECT_TRUE(piece_fault([&](PathPiece& p) { p.times[1] = infinite; }));
  EXPECT_TRUE(piece_fault([](PathPiece& p) {
    p.times.resize(kPathPieceDoubles);
    p.configurations.resize(3 * kPathPieceDoubles);
  }));
}

}  // namespace
}  // namespace accord
