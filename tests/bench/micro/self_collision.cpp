// Arms against themselves, nothing else there: at rest, and on short motions.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "tests/bench/micro/counters.h"
#include "tests/bench/micro/examples.h"
#include "tests/contract/test_scenes.h"

namespace accord::micro {
namespace {

constexpr std::size_t kCount = 256;

void measure(benchmark::State& state, const std::shared_ptr<const RobotModel>& model, bool planar,
             double stride) {
  const CollisionWorld world(test_scenes::SceneBuilder(planar).add(model).build(), kPlanningMargin);
  test_scenes::Random random(5);
  std::vector<Configuration> from, to;
  for (std::size_t i = 0; i < kCount; ++i) {
    from.push_back(test_scenes::random_configuration(*model, random, 3));
    const Configuration other = test_scenes::random_configuration(*model, random, 3);
    Configuration& end = to.emplace_back(from.back());
    for (std::size_t k = 0; k < end.size(); ++k) end[k] += stride * (other[k] - end[k]);
  }
  std::size_t free = 0;
  {
    const DistanceRate rate(state, world);
    for ([[maybe_unused]] auto _ : state) {
      free = 0;
      for (std::size_t i = 0; i < kCount; ++i) {
        free += world.motion_is_free({0}, from[i], to[i]) ? 1U : 0U;
      }
      benchmark::DoNotOptimize(free);
    }
  }
  count_items(state, kCount);
  state.counters["free"] = static_cast<double>(free) / kCount;
}

[[maybe_unused]] const bool kAdded = [] {
  struct Case {
    const char* name;
    std::shared_ptr<const RobotModel> model;
    bool planar;
  };
  const std::vector<Case> cases{{"planar-arm-3", test_scenes::planar_arm(), true},
                                {"arm-6", test_scenes::six_joint_arm(), false},
                                {"panda", example("panda-four")->robots[0].model, false}};
  for (const Case& of : cases) {
    const std::string name = of.name;
    benchmark::RegisterBenchmark(("self/rest/" + name).c_str(), [of](benchmark::State& state) {
      measure(state, of.model, of.planar, 0);
    });
    benchmark::RegisterBenchmark(("self/motion/" + name).c_str(), [of](benchmark::State& state) {
      measure(state, of.model, of.planar, 0.1);
    });
  }
  return true;
}();

}  // namespace
}  // namespace accord::micro
