// How benchmarks count what they do.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>

#include "common/geometry/collision_world.h"

namespace accord::micro {

// `items` were dealt with in each iteration: items_per_second.
inline void count_items(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

// Adds the rate of a world's distance queries while it lives: distances_per_second.
class DistanceRate {
 public:
  DistanceRate(benchmark::State& state, const CollisionWorld& world)
      : state_(state), world_(world), before_(world.distance_queries()) {}
  ~DistanceRate() {
    const auto queries = static_cast<double>(world_.distance_queries() - before_);
    state_.counters["distances_per_second"] =
        benchmark::Counter(queries, benchmark::Counter::kIsRate);
  }
  DistanceRate(const DistanceRate&) = delete;
  DistanceRate& operator=(const DistanceRate&) = delete;

 private:
  benchmark::State& state_;
  const CollisionWorld& world_;
  std::uint64_t before_;
};

}  // namespace accord::micro
