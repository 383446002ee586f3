#include "client/engine/planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <thread>

#include "common/io/plan_file.h"
#include "common/planning/method_names.h"
#include "common/planning/verifier.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using testing::SceneBuilder;
using ::testing::SizeIs;
using ::testing::StartsWith;

// Two discs that change places in a corridor with a bay in which one can let the other pass.
std::shared_ptr<const Scene> corridor() {
  return SceneBuilder(-5, -1, 5, 3)
      .clearance(0.05)
      .box(-5, 1, -1, 3)
      .box(1, 1, 5, 3)
      .disk(0.3, {-4, 0}, {4, 0})
      .disk(0.3, {4, 0}, {-4, 0})
      .build();
}

// The corridor cut in two.
std::shared_ptr<const Scene> dead_end() {
  return SceneBuilder(-5, -1, 5, 3).box(-0.5, -1, 0.5, 3).disk(0.3, {-4, 0}, {4, 0}).build();
}

// Discs that change places in pairs, each pair where it meets no other: work for several threads.
std::shared_ptr<const Scene> lanes(int count) {
  SceneBuilder builder(-5, -2, 5, 4.0 * count);
  for (int lane = 0; lane < count; ++lane) {
    const double y = 4.0 * lane;
    builder.disk(0.3, {-4, y}, {4, y}).disk(0.3, {4, y}, {-4, y});
  }
  return builder.build();
}

double statistic(const Plan& plan, const std::string& name) {
  for (const auto& [key, value] : plan.statistics) {
    if (key == name) return value;
  }
  ADD_FAILURE() << "no statistic " << name;
  return -1;
}

TEST(Planner, SolvesASceneAndProvesIt) {
  const auto scene = corridor();
  const Plan found = plan(scene, {});
  ASSERT_EQ(found.status, PlanStatus::kSolved) << found.message;
  EXPECT_EQ(found.message, "");
  EXPECT_EQ(found.scene, "test");
  ASSERT_THAT(found.robots, SizeIs(2));
  EXPECT_EQ(found.robots[0].name, "r0");
  EXPECT_TRUE(verify(scene, found).proved());
  EXPECT_GE(found.makespan, 8);
  EXPECT_GT(found.planning_time, 0);
}

TEST(Planner, SaysByWhichSolverAndInWhichCompanyEachStretchWasPlanned) {
  const Plan found = plan(corridor(), {});
  ASSERT_EQ(found.status, PlanStatus::kSolved);
  std::set<std::string> solvers;
  for (const RobotPlan& robot : found.robots) {
    ASSERT_FALSE(robot.segments.empty());
    for (const PlanSegment& segment : robot.segments) {
      solvers.insert(segment.solver);
      EXPECT_THAT(segment.robots, Contains(robot.name));
    }
  }
  EXPECT_GT(solvers.size(), 1U) << "the robots' own paths, and what resolved their conflict";
}

// There was once a gap where the robot waited, from its arrival, here at once, to when it moved
// again.
TEST(Planner, LeavesNoGapWhereARobotThatHadArrivedMakesWay) {
  const auto scene = SceneBuilder(-5, -0.5, 5, 3)
                         .box(-5, 0.5, -1, 3)
                         .box(1, 0.5, 5, 3)
                         .disk(0.3, {-4, 0}, {4, 0})
                         .disk(0.3, {2.5, 0}, {2.5, 0})
                         .build();
  const Plan found = plan(scene, {});
  ASSERT_EQ(found.status, PlanStatus::kSolved) << found.message;
  const RobotPlan& parked = found.robots[1];
  ASSERT_GT(parked.trajectory.end_time(), 0) << "it has to make way";
  ASSERT_FALSE(parked.segments.empty());
  EXPECT_EQ(parked.segments.front().from, 0);
  EXPECT_EQ(parked.segments.back().to, parked.trajectory.end_time());
  for (std::size_t i = 1; i < parked.segments.size(); ++i) {
    EXPECT_EQ(parked.segments[i].from, parked.segments[i - 1].to);
    EXPECT_GT(parked.segments[i].to, parked.segments[i].from);
  }
}

TEST(Planner, SaysWhichRobotHasNoWay) {
  const Plan found = plan(dead_end(), {});
  EXPECT_EQ(found.status, PlanStatus::kInfeasible);
  EXPECT_THAT(found.message, HasSubstr("\"r0\""));
  EXPECT_THAT(found.robots, SizeIs(0));
}

// Holds the planner up at its first report for long enough that its watchdog has barked.
ProgressCallback once(const std::function<void()>& action) {
  return [action, first = true](const Progress&) mutable {
    if (!first) return;
    first = false;
    action();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  };
}

TEST(Planner, EndsWhenTheDeadlinePasses) {
  PlanOptions options;
  options.timeout = 1e-3;
  const Plan found = plan(lanes(8), options, once([] {}));
  EXPECT_EQ(found.status, PlanStatus::kTimeout);
  EXPECT_THAT(found.message, StartsWith("the deadline passed "));
  EXPECT_THAT(found.robots, SizeIs(0));
}

TEST(Planner, EndsWhenItIsCancelled) {
  std::atomic<bool> cancel = false;
  const Plan found = plan(lanes(8), {}, once([&] { cancel = true; }), &cancel);
  EXPECT_EQ(found.status, PlanStatus::kCancelled);
  EXPECT_THAT(found.message, StartsWith("cancelled "));
  EXPECT_THAT(found.robots, SizeIs(0));
}

TEST(Planner, CountsWhatItDid) {
  const Plan found = plan(corridor(), {});
  EXPECT_GE(statistic(found, "conflicts_found"), 1);
  EXPECT_GE(statistic(found, "conflicts_resolved"), 1);
  EXPECT_GE(statistic(found, "rounds"), 1);
  EXPECT_GE(statistic(found, "subproblems"), statistic(found, "conflicts_resolved"));
  EXPECT_GE(statistic(found, "lower_bound"), 16 - 1e-6) << "8 m each at 1 m/s";
  EXPECT_LE(statistic(found, "lower_bound"), found.sum_of_costs);
  EXPECT_GE(statistic(found, "distance_queries"), statistic(found, "conflicts_found"));
  for (const char* name : {"searches", "expansions", "samples", "motion_checks", "pair_checks",
                           "initial_paths_time", "conflicts_time", "proof_time"}) {
    EXPECT_GE(statistic(found, name), 0) << name;
  }
}

TEST(Planner, CountsWhatItDidBeforeItFailed) {
  EXPECT_GE(statistic(plan(dead_end(), {}), "samples"), 0);
}

TEST(Planner, MakesTheSamePlanForAnyNumberOfWorkers) {
  const auto scene = lanes(6);
  std::set<std::string> texts;
  for (const unsigned workers : {1U, 3U}) {
    PlanOptions options;
    options.threads = workers;
    texts.insert(canonical_bytes(plan(scene, options)));
  }
  EXPECT_THAT(texts, SizeIs(1));
}

TEST(Planner, HandsOutTheSeedThatItWasGiven) {
  PlanOptions options;
  options.seed = 18446744073709551615U;
  EXPECT_EQ(plan(corridor(), options).seed, options.seed);
}

TEST(Planner, UsesNoSolversButThoseItWasGiven) {
  for (const std::string& solver : local_solver_names()) {
    PlanOptions options;
    options.solvers = {solver};
    const Plan found = plan(corridor(), options);
    for (const auto& [name, value] : found.statistics) {
      if (!name.starts_with("solved_by_")) continue;
      EXPECT_EQ(name, "solved_by_" + solver);
    }
  }
}

TEST(Planner, ReportsWhatThePathsCostAndHowManyConflictsAreLeft) {
  std::optional<Progress> first, last;
  const Plan found = plan(corridor(), {}, [&](const Progress& progress) {
    if (!first && progress.phase == Progress::Phase::kConflicts) first = progress;
    last = progress;
  });
  ASSERT_TRUE(first);
  EXPECT_GE(first->conflicts_left, 1U);
  EXPECT_EQ(first->conflicts_left, first->conflicts_found);
  EXPECT_NEAR(first->sum_of_costs, 16, 1e-5) << "8 m each at 1 m/s";
  EXPECT_EQ(last->phase, Progress::Phase::kProof);
  EXPECT_EQ(last->conflicts_left, 0U);
  EXPECT_EQ(last->sum_of_costs, found.sum_of_costs);
  EXPECT_EQ(static_cast<double>(last->conflicts_found), statistic(found, "conflicts_found"));
}

TEST(Planner, ReportsEachPhaseOnTheCallersThread) {
  std::vector<Progress::Phase> phases;
  const Plan found =
      plan(corridor(), {}, [&, caller = std::this_thread::get_id()](const Progress& progress) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        if (phases.empty() || phases.back() != progress.phase) phases.push_back(progress.phase);
      });
  ASSERT_EQ(found.status, PlanStatus::kSolved);
  EXPECT_THAT(phases, ::testing::ElementsAre(Progress::Phase::kInitialPaths,
                                             Progress::Phase::kConflicts, Progress::Phase::kProof));
}

}  // namespace
}  // namespace accord
