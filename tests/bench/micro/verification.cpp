// The proof of whole plans, on one thread: of discs in closed form, of arms by advancement. What is
// proved is a second of one robot's motion: items. The plan itself is made once, before.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "common/planning/verifier.h"
#include "tests/bench/micro/counters.h"
#include "tests/bench/micro/examples.h"

namespace accord::micro {
namespace {

void measure(benchmark::State& state, const std::string& name, Beyond beyond) {
  const std::shared_ptr<const Scene> scene = example(name);
  const Plan plan = example_plan(scene);
  bool proved = true;
  for ([[maybe_unused]] auto _ : state) proved = proved && verify(scene, plan, 1, beyond).proved();
  if (!proved) state.SkipWithError("the plan does not hold");
  count_items(state, static_cast<std::size_t>(plan.sum_of_costs));
}

[[maybe_unused]] const bool kAdded = [] {
  for (const std::string name : {"adaptive-mobile", "fleet-0050", "carts-6", "panda-four"}) {
    benchmark::RegisterBenchmark(("verify/proof/" + name).c_str(), [name](benchmark::State& state) {
      measure(state, name, Beyond::kNothing);
    })->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(
        ("verify/separations/" + name).c_str(),
        [name](benchmark::State& state) { measure(state, name, Beyond::kSeparations); })
        ->Unit(benchmark::kMicrosecond);
  }
  return true;
}();

}  // namespace
}  // namespace accord::micro
