// The nearest nodes of a roadmap, as its construction and every local problem ask for them; and
// beside it a bare scan of all nodes, which is what an index has to beat.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "tests/bench/micro/counters.h"
#include "tests/contract/test_scenes.h"
#include "worker/shared_roadmap.h"

namespace accord::micro {
namespace {

constexpr std::size_t kQueries = 256;
constexpr std::size_t kNeighbours = 12;
constexpr double kSpan = 20;  // m, where there are no limits

std::vector<Configuration> configurations(const RobotModel& model, std::size_t count,
                                          unsigned seed) {
  test_scenes::Random random(seed);
  std::vector<Configuration> out;
  for (std::size_t i = 0; i < count; ++i) {
    out.push_back(test_scenes::random_configuration(model, random, kSpan));
  }
  return out;
}

void nearest(benchmark::State& state, const std::shared_ptr<const RobotModel>& model, bool planar) {
  const CollisionWorld world(test_scenes::SceneBuilder(planar).add(model).build(), kPlanningMargin);
  const SharedRoadmap roadmap(world, {0},
                              configurations(*model, static_cast<std::size_t>(state.range(0)), 1));
  const std::vector<Configuration> queries = configurations(*model, kQueries, 2);
  std::vector<SharedRoadmap::Node> found;
  for ([[maybe_unused]] auto _ : state) {
    for (const Configuration& q : queries) {
      roadmap.nearest(q, kNeighbours, found);
      benchmark::DoNotOptimize(found.data());
    }
  }
  count_items(state, kQueries);
}

void nearest_disc(benchmark::State& state) {
  nearest(state, test_scenes::disk(0.3), true);
}
BENCHMARK(nearest_disc)->Name("nearest/disc")->Arg(800)->Arg(12800);

void nearest_arm(benchmark::State& state) {
  nearest(state, test_scenes::six_joint_arm(), false);
}
BENCHMARK(nearest_arm)->Name("nearest/arm-6")->Arg(2400)->Arg(9600);

// The one nearest of all nodes, by their squared distances, coordinate by coordinate.
void scan(benchmark::State& state, std::size_t dof) {
  const auto nodes = static_cast<std::size_t>(state.range(0));
  test_scenes::Random random(1);
  std::vector<double> values(nodes * dof);
  for (double& x : values) x = test_scenes::uniform(random, -kSpan, kSpan);
  std::vector<double> squared(nodes);
  for ([[maybe_unused]] auto _ : state) {
    std::ranges::fill(squared, 0.0);
    for (std::size_t k = 0; k < dof; ++k) {
      const double* column = values.data() + k * nodes;
      for (std::size_t i = 0; i < nodes; ++i) squared[i] += column[i] * column[i];
    }
    double least = std::numeric_limits<double>::infinity();
    for (const double d : squared) least = d < least ? d : least;
    benchmark::DoNotOptimize(least);
  }
  count_items(state, 1);
}

void scan_disc(benchmark::State& state) {
  scan(state, 2);
}
BENCHMARK(scan_disc)->Name("limit/nearest/disc")->Arg(800)->Arg(12800);

void scan_arm(benchmark::State& state) {
  scan(state, 6);
}
BENCHMARK(scan_arm)->Name("limit/nearest/arm-6")->Arg(2400)->Arg(9600);

}  // namespace
}  // namespace accord::micro
