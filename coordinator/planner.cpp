#include "coordinator/planner.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <stdexcept>
#include <utility>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "common/planning/method_names.h"
#include "common/planning/verifier.h"
#include "common/runtime/log.h"
#include "coordinator/arc.h"
#include "coordinator/foreman.h"
#include "coordinator/watchdog.h"
#include "coordinator/whole_problem.h"

namespace accord {
namespace {

constexpr auto kReportEvery = std::chrono::milliseconds(50);

using Clock = std::chrono::steady_clock;

ProgressCallback thinned(const ProgressCallback& progress) {
  if (!progress) return {};
  return [progress, last = Clock::time_point{},
          phase = std::optional<Progress::Phase>{}](const Progress& now) mutable {
    if (phase == now.phase && Clock::now() - last < kReportEvery) return;
    phase = now.phase;
    last = Clock::now();
    progress(now);
  };
}

std::vector<PlanSegment> segments(const Scene& scene,
                                  const std::vector<CouplingSegment>& coupling) {
  std::vector<PlanSegment> out;
  for (const CouplingSegment& segment : coupling) {
    PlanSegment named{segment.from, segment.to, {}, segment.solver};
    for (const RobotId robot : segment.robots) named.robots.push_back(scene.robot(robot).name);
    out.push_back(std::move(named));
  }
  return out;
}

// A line for each segment of the plan, as it has it: what it came of. For who goes back from a plan
// to the tasks that made it.
void log_segments(const Scene& scene, const Schedule& schedule) {
  if (!logs(LogLevel::kDebug)) return;
  for (std::uint32_t id = 0; id < scene.robots.size(); ++id) {
    for (const CouplingSegment& segment : schedule.coupling({id})) {
      log(LogLevel::kDebug, "segment of the plan",
          {{"robot", scene.robot({id}).name},
           {"from", segment.from},
           {"to", segment.to},
           {"solver", segment.solver},
           {"subproblem", segment.subproblem}});
    }
  }
}

void fill_robots(const Scene& scene, const Schedule& schedule, Plan& plan) {
  for (std::uint32_t id = 0; id < scene.robots.size(); ++id) {
    RobotPlan robot;
    robot.name = scene.robot({id}).name;
    robot.trajectory = schedule.path({id});
    robot.segments = segments(scene, schedule.coupling({id}));
    plan.robots.push_back(std::move(robot));
  }
  compute_costs(plan);
}

void fill_statistics(const PlanningStatistics& from, Plan& plan) {
  const auto add = [&](std::string name, auto value) {
    plan.statistics.emplace_back(std::move(name), static_cast<double>(value));
  };
  add("conflicts_found", from.conflicts_found);
  add("conflicts_resolved", from.conflicts_resolved);
  add("rounds", from.rounds);
  add("subproblems", from.subproblems);
  add("subproblems_exhausted", from.exhausted);
  for (const auto& [solver, count] : from.solved_by) add("solved_by_" + solver, count);
  add("windows_grown", from.windows_grown);
  add("robots_taken_in", from.robots_taken_in);
  add("searches", from.effort.searches);
  add("expansions", from.effort.expansions);
  add("samples", from.effort.samples);
  add("motion_checks", from.effort.motion_checks);
  add("pair_checks", from.pair_checks);
  add("distance_queries", from.effort.distance_queries + from.distance_queries);
  add("lower_bound", from.lower_bound);
  add("initial_paths_time", from.initial_time);
  add("conflicts_time", from.conflict_time);
}

// What solves subproblems: ARC's hierarchy, or the baseline's one solver.
std::vector<std::string> hierarchy(const PlanOptions& options) {
  if (options.method != kArcMethod) return {options.method};
  return options.solvers.empty() ? default_solver_names() : options.solvers;
}

}  // namespace

Plan unsolved_plan(const Scene* scene, const PlanOptions& options, PlanStatus status,
                   std::string message) {
  Plan plan;
  if (scene != nullptr) {
    plan.scene = scene->name;
    plan.timestep = scene->timestep;
  }
  plan.method = options.method;
  plan.seed = options.seed;
  plan.status = status;
  plan.message = std::move(message);
  return plan;
}

Plan plan_with(const CrewFactory& make_crew, const std::shared_ptr<const Scene>& scene,
               const PlanOptions& options, const ProgressCallback& progress,
               const std::atomic<bool>* cancel) {
  const auto begin = Clock::now();
  const Watchdog watchdog(options.timeout, cancel);
  const CollisionWorld planning(scene, kPlanningMargin);
  const CollisionWorld detection(scene, kDetectionMargin);
  Foreman workforce(make_crew(planning, detection), hierarchy(options));
  const ProgressCallback report = thinned(progress);
  std::unique_ptr<Method> method;
  if (options.method == kArcMethod) {
    method = std::make_unique<Arc>(planning, detection, options.seed, workforce, watchdog.stop(),
                                   report);
  } else {
    method = std::make_unique<WholeProblem>(planning, detection, options.seed, workforce,
                                            watchdog.stop(), report);
  }

  const Outcome outcome = method->run();
  Plan plan = unsolved_plan(scene.get(), options, outcome.status, outcome.message);
  if (outcome.status == PlanStatus::kCancelled) {
    if (watchdog.timed_out()) plan.status = PlanStatus::kTimeout;
    plan.message = (watchdog.timed_out() ? "the deadline passed " : "cancelled ") + outcome.message;
  }
  fill_statistics(method->statistics(), plan);
  if (plan.status == PlanStatus::kSolved) {
    fill_robots(*scene, method->schedule(), plan);
    log_segments(*scene, method->schedule());
    if (report) {
      const PlanningStatistics& done = method->statistics();
      report({Progress::Phase::kProof, scene->robots.size(), done.conflicts_found,
              done.conflicts_resolved, done.rounds, 0, plan.sum_of_costs});
    }
    const auto proof_begin = Clock::now();
    const Verdict verdict = verify(scene, plan, options.threads, Beyond::kNothing);
    if (!verdict.proved()) {
      throw std::logic_error("the planner made a plan that does not hold: " +
                             verdict.violation->text);
    }
    plan.statistics.emplace_back("proof_time",
                                 std::chrono::duration<double>(Clock::now() - proof_begin).count());
  }
  plan.planning_time = std::chrono::duration<double>(Clock::now() - begin).count();
  return plan;
}

}  // namespace accord
