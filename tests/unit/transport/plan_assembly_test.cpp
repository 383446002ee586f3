// Plans are cut into bounded pieces and come together again, whatever happens to those.
#include "common/transport/fleet/plan_assembly.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/io/plan_file.h"
#include "common/planning/random.h"
#include "common/transport/fleet/fleet_limits.h"
#include "common/transport/fleet/plan_pieces.h"
#include "tests/contract/fleet_samples.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using fleet_samples::bits_of;
using fleet_samples::plan_of;
using Ids = std::vector<std::string>;

std::vector<PathPiece> all_pieces(const FinishedPlan& plan) {
  const PlanPieces cut(plan);
  std::vector<PathPiece> out;
  for (std::size_t robot = 0; robot < plan.plan.robots.size(); ++robot) {
    std::ranges::move(cut.of_robot(robot), std::back_inserter(out));
  }
  return out;
}

class Assembly : public testing::Test {
 protected:
  // Whether this part completed the plan; and that it is the right one.
  template <typename Part>
  bool completes(Part part) {
    const auto given = assembly_.add(std::move(part), now_);
    if (given) {
      EXPECT_EQ(given->id, plan_.id);
      EXPECT_EQ(given->content, plan_.content);
      EXPECT_EQ(bits_of(given->plan), bits_of(plan_.plan));
      EXPECT_EQ(to_json(given->plan), to_json(plan_.plan));
    }
    return given.has_value();
  }

  FinishedPlan plan_ = plan_of("1", 5, 20);
  PlanOutline outline_ = PlanPieces(plan_).outline();
  std::vector<PathPiece> pieces_ = all_pieces(plan_);
  PlanAssembly assembly_{200ms};
  PlanAssembly::Time now_{1h};
};

// ---- Cutting ----

TEST(PlanPieces, AreBoundedAndTravel) {
  for (const auto& [robots, waypoints] : {std::pair(1UL, 0UL), {3UL, 1UL}, {2UL, 50'000UL}}) {
    const FinishedPlan plan = plan_of("1", robots, std::max(waypoints, 1UL));
    for (const PathPiece& piece : all_pieces(plan)) {
      EXPECT_LE(content_bytes(piece), kPathPieceBytes);
      EXPECT_EQ(fleet_fault(FleetPart(piece)), std::nullopt);
    }
  }
}

TEST(PlanPieces, OfSegmentsWithCrowdsAreBoundedToo) {
  FinishedPlan plan = plan_of("1", 2'000, 1);
  PlanSegment crowd{0, 1, {}, "crowd"};
  for (const RobotPlan& robot : plan.plan.robots) crowd.robots.push_back(robot.name);
  plan.plan.robots[7].segments.assign(100, crowd);
  const auto pieces = PlanPieces(plan).of_robot(7);
  EXPECT_GT(pieces.size(), 10);
  for (const PathPiece& piece : pieces) EXPECT_LE(content_bytes(piece), kPathPieceBytes);
  PlanAssembly assembly(1s);
  assembly.add(PlanPieces(plan).outline(), 0s);
  std::optional<FinishedPlan> given;
  for (PathPiece& piece : all_pieces(plan)) given = assembly.add(std::move(piece), 0s);
  ASSERT_TRUE(given);
  EXPECT_EQ(bits_of(given->plan), bits_of(plan.plan));
}

TEST(PlanPieces, OfARobotWithoutAPathAreOne) {
  FinishedPlan plan{"1", {}};
  plan.plan.robots.push_back({"r0", Trajectory(2), {}});
  const auto pieces = all_pieces(plan);
  ASSERT_EQ(pieces.size(), 1);
  PlanAssembly assembly(1s);
  EXPECT_FALSE(assembly.add(pieces[0], 0s));
  const auto given = assembly.add(PlanPieces(plan).outline(), 0s);
  ASSERT_TRUE(given);
  EXPECT_EQ(bits_of(given->plan), bits_of(plan.plan));
}

// ---- Putting together ----

TEST_F(Assembly, GivesThePlanInWhateverOrderItComes) {
  plan_ = plan_of("1", 4, 9'000);
  outline_ = PlanPieces(plan_).outline();
  pieces_ = all_pieces(plan_);
  ASSERT_GT(pieces_.size(), 12);
  RandomStream random(1);
  for (int round = 0; round < 20; ++round) {
    assembly_ = PlanAssembly(200ms);
    for (std::size_t i = pieces_.size(); i > 1; --i) {
      std::swap(pieces_[i - 1], pieces_[random.below(i)]);
    }
    const std::size_t outline_after = random.below(pieces_.size() + 1);
    std::size_t given = 0;
    for (std::size_t i = 0; i <= pieces_.size(); ++i) {
      if (i == outline_after) given += completes(outline_);
      if (i == pieces_.size()) break;
      given += completes(pieces_[i]);
      given += completes(pieces_[random.below(i + 1)]);  // one that was here before
    }
    EXPECT_EQ(given, 1);
  }
}

TEST_F(Assembly, GivesAPlanOnceUnlessItIsAskedForAgain) {
  const auto send_all = [&] {
    int given = completes(outline_);
    for (const PathPiece& piece : pieces_) given += completes(piece);
    return given;
  };
  EXPECT_EQ(send_all(), 1);
  EXPECT_EQ(send_all(), 0);
  assembly_.expect("1");
  EXPECT_EQ(send_all(), 1);
  EXPECT_EQ(send_all(), 0);
}

TEST_F(Assembly, PrefersHigherVersions) {
  EXPECT_FALSE(completes(outline_));
  for (PathPiece& piece : pieces_) piece.version = 2;
  for (const PathPiece& piece : pieces_) EXPECT_FALSE(completes(piece));
  EXPECT_FALSE(completes(outline_));  // late
  outline_.version = 2;
  EXPECT_TRUE(completes(outline_));
  outline_.version = 1;
  EXPECT_FALSE(completes(outline_));
  EXPECT_FALSE(assembly_.next_overdue());
}

// ---- Asking again ----

TEST_F(Assembly, AsksForPlansWithGapsLessAndLessOftenAndInTheEndForgetsThem) {
  EXPECT_EQ(assembly_.next_overdue(), std::nullopt);
  completes(outline_);
  EXPECT_EQ(assembly_.next_overdue(), now_ + 200ms);
  EXPECT_EQ(assembly_.overdue(now_ + 199ms), Ids{});
  EXPECT_EQ(assembly_.overdue(now_ + 200ms), Ids{"1"});
  EXPECT_EQ(assembly_.overdue(now_ + 599ms), Ids{});
  EXPECT_EQ(assembly_.overdue(now_ + 600ms), Ids{"1"});
  // What comes begins the waiting anew.
  now_ += 700ms;
  completes(pieces_[0]);
  EXPECT_EQ(assembly_.next_overdue(), now_ + 200ms);
  int asked = 0;
  while (const auto due = assembly_.next_overdue()) asked += !assembly_.overdue(*due).empty();
  EXPECT_EQ(asked, 6);
  // It may begin to come again.
  completes(outline_);
  EXPECT_EQ(assembly_.next_overdue(), now_ + 200ms);
}

TEST_F(Assembly, AsksForPlansThatAreThereIfItExpectsThem) {
  assembly_.note_finished("1", now_);
  EXPECT_EQ(assembly_.next_overdue(), std::nullopt);
  assembly_.expect("1");
  assembly_.note_finished("1", now_);
  EXPECT_EQ(assembly_.overdue(now_ + 200ms), Ids{"1"});
  completes(outline_);
  for (const PathPiece& piece : pieces_) completes(piece);
  assembly_.note_finished("1", now_);
  EXPECT_EQ(assembly_.next_overdue(), std::nullopt);
}

// ---- Hostile parts ----

TEST_F(Assembly, DropsPartsThatContradictOthers) {
  completes(pieces_[0]);
  PathPiece other = pieces_[0];
  other.pieces = 2;
  other.piece = 1;
  completes(other);
  EXPECT_EQ(assembly_.malformed(), 1);
  other = pieces_[0];
  other.robot = "somebody else";
  completes(other);
  EXPECT_EQ(assembly_.malformed(), 2);
}

// A service was killed as its plan was on its way, and the request was cancelled after that.
TEST_F(Assembly, GivesAnEndWithoutPathsWhateverHasComeOfAPlanBefore) {
  completes(outline_);
  completes(pieces_[0]);
  PlanOutline cancelled = outline_;
  cancelled.plan.robots.clear();
  cancelled.plan.status = PlanStatus::kCancelled;
  const auto given = assembly_.add(cancelled, now_);
  ASSERT_TRUE(given);
  EXPECT_EQ(given->plan.status, PlanStatus::kCancelled);
  EXPECT_EQ(assembly_.malformed(), 0U);
}

TEST_F(Assembly, DropsPlansThatAreNone) {
  const auto spoilt_by = [&](const auto& spoil) {
    assembly_ = PlanAssembly(200ms);
    std::vector<PathPiece> pieces = pieces_;
    spoil(pieces[3]);
    bool given = completes(outline_);
    for (const PathPiece& piece : pieces) given = completes(piece) || given;
    EXPECT_EQ(assembly_.next_overdue(), std::nullopt);
    return !given && assembly_.malformed() == 1;
  };
  EXPECT_TRUE(spoilt_by([](PathPiece& p) { p.times[3] = p.times[2]; }));
  EXPECT_TRUE(spoilt_by([](PathPiece& p) { p.segments[0].robots = {5}; }));
  EXPECT_TRUE(spoilt_by([](PathPiece& p) { p.robot_index = 9; }));
  EXPECT_TRUE(spoilt_by([](PathPiece& p) { p.robot = "somebody else"; }));
}

TEST_F(Assembly, RemembersOnlySoManyIncompletePlans) {
  completes(outline_);
  for (int i = 2; i < 1'000; ++i) {
    now_ += 1us;
    outline_.id = std::to_string(i);
    assembly_.add(outline_, now_);
  }
  EXPECT_EQ(assembly_.overdue(now_ + 1s).size(), 64);
}

TEST_F(Assembly, RemembersOnlySoMuchOfAPlan) {
  PathPiece piece = pieces_[0];
  piece.pieces = kPathPieces;
  piece.times.assign(kPathPieceDoubles / 4, 0);
  piece.configurations.assign(3 * kPathPieceDoubles / 4, 0);
  // More than any plan may have: it is forgotten, and begins anew.
  for (std::uint32_t i = 0; i < 6'000; ++i) {
    piece.piece = i;
    completes(piece);
  }
  EXPECT_EQ(assembly_.malformed(), 1);
}

}  // namespace
}  // namespace accord
