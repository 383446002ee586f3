// Each solver of the hierarchy, and those that are not in it by default, on subproblems that never
// change: those of the solvers' contract test. The robots' own roadmaps are there already, as they
// are for most subproblems of a scene. "solved" is 0 where a solver cannot: what a level costs that
// fails is what the next one waits for.
#include <benchmark/benchmark.h>

#include <atomic>
#include <string>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "tests/bench/micro/counters.h"
#include "tests/support/problems.h"
#include "worker/solver.h"
#include "worker/workspace.h"

namespace accord::micro {
namespace {

void measure(benchmark::State& state, const std::string& name, testing::Problem (*make)()) {
  const testing::Problem problem = make();
  const CollisionWorld world(problem.scene, kPlanningMargin);
  const Workspace workspace(world);
  const auto solver = make_solver(name);
  const std::atomic<bool> stop{false};
  Resolution found = solver->solve(workspace, problem.subproblem, stop);
  {
    const DistanceRate rate(state, world);
    for ([[maybe_unused]] auto _ : state) {
      found = solver->solve(workspace, problem.subproblem, stop);
    }
  }
  count_items(state, 1);
  state.counters["solved"] = found.solved ? 1 : 0;
  state.counters["expansions"] = static_cast<double>(found.effort.expansions);
}

[[maybe_unused]] const bool kAdded = [] {
  struct Case {
    const char* name;
    testing::Problem (*make)();
  };
  const std::vector<Case> local{{"crossing-discs", testing::crossing_discs},
                                {"swap-and-passer-by", testing::swapping_discs_and_a_passer_by},
                                {"pocket", testing::discs_in_a_corridor_with_a_pocket},
                                {"swapping-carts", testing::swapping_carts},
                                {"arms", testing::arms_that_change_sides}};
  const auto add = [](const std::string& solver, const Case& of) {
    benchmark::RegisterBenchmark(
        ("solver/" + solver + "/" + of.name).c_str(),
        [solver, make = of.make](benchmark::State& state) { measure(state, solver, make); })
        ->Unit(benchmark::kMicrosecond);
  };
  for (const char* solver :
       {"prioritized-query", "decoupled-prm", "composite-prm", "composite-rrt-connect"}) {
    for (const Case& of : local) add(solver, of);
  }
  add("prioritized-query", {"crowd", testing::crowd});
  add("lockstep-query", {"crowd", testing::crowd_in_lockstep});
  return true;
}();

}  // namespace
}  // namespace accord::micro
