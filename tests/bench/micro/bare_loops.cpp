// Physical limits: the arithmetic of a question, and nothing else, in a loop over contiguous data.
// What stands beside them in the other files asks the same through the interface that planning
// uses, with its filters, certificates and bookkeeping; the ratio is what these cost.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "common/geometry/closed_forms.h"
#include "common/geometry/point_motion.h"
#include "tests/bench/micro/counters.h"

namespace accord::micro {
namespace {

constexpr std::size_t kCount = 4096;

// Numbers of one kind, one after the other.
std::vector<double> numbers(unsigned seed, double low, double high) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(low, high);
  std::vector<double> out(kCount);
  for (double& x : out) x = uniform(random);
  return out;
}

std::vector<Vec3> vectors(unsigned seed, double span) {
  const std::vector<double> x = numbers(seed, -span, span), y = numbers(seed + 1, -span, span),
                            z = numbers(seed + 2, -span, span);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < kCount; ++i) out.emplace_back(x[i], y[i], z[i]);
  return out;
}

std::vector<Vec3> directions(unsigned seed) {
  std::vector<Vec3> out = vectors(seed, 1);
  for (Vec3& v : out) v.normalize();
  return out;
}

void sphere_sphere_distance(benchmark::State& state) {
  const std::vector<double> x = numbers(1, -1, 1), y = numbers(2, -1, 1), z = numbers(3, -1, 1);
  std::vector<double> out(kCount);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < kCount; ++i) {
      out[i] = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]) - 0.4;
    }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  count_items(state, kCount);
}
BENCHMARK(sphere_sphere_distance)->Name("limit/distance/sphere-sphere");

// The box at rest; its axes are the coordinates'.
void sphere_box_distance(benchmark::State& state) {
  const std::vector<Vec3> centres = vectors(1, 1);
  const Vec3 half(0.2, 0.15, 0.1);
  std::vector<double> out(kCount);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < kCount; ++i) out[i] = to_box<3>(centres[i], half).norm() - 0.2;
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  count_items(state, kCount);
}
BENCHMARK(sphere_box_distance)->Name("limit/distance/sphere-box");

void capsule_capsule_distance(benchmark::State& state) {
  const std::vector<Vec3> offsets = vectors(1, 1), u = directions(4), v = directions(7);
  std::vector<double> out(kCount);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < kCount; ++i) {
      const SegmentParameters at = closest_on_segments<3>(u[i], 0.2, offsets[i], v[i], 0.2);
      out[i] = (offsets[i] + at.b * v[i] - at.a * u[i]).norm() - 0.2;
    }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  count_items(state, kCount);
}
BENCHMARK(capsule_capsule_distance)->Name("limit/distance/capsule-capsule");

// Whether two discs on linear motions touch at any instant, without a division or a branch.
void disc_pair_motion(benchmark::State& state) {
  const std::vector<double> x = numbers(1, -3, 3), y = numbers(2, -3, 3), dx = numbers(3, -2, 2),
                            dy = numbers(4, -2, 2);
  std::vector<double> touch(kCount);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < kCount; ++i) {
      const double a = dx[i] * dx[i] + dy[i] * dy[i];
      const double b = x[i] * dx[i] + y[i] * dy[i];
      const double c = x[i] * x[i] + y[i] * y[i] - 1;  // below 0: they touch at the start
      const double at_end = a + 2 * b + c;
      const double between =
          std::max(std::max(b, -b - a), a * c - b * b);  // below 0: in the middle
      touch[i] = std::min(std::min(c, at_end), between);
    }
    benchmark::DoNotOptimize(touch.data());
    benchmark::ClobberMemory();
  }
  count_items(state, kCount);
}
BENCHMARK(disc_pair_motion)->Name("limit/motion/disc-disc");

// When they first touch, as planning asks it.
void disc_pair_first_contact(benchmark::State& state) {
  std::vector<Vec3> offsets = vectors(1, 3), drifts = vectors(4, 2);
  for (std::size_t i = 0; i < kCount; ++i) offsets[i].z() = drifts[i].z() = 0;
  std::vector<double> out(kCount);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < kCount; ++i) {
      out[i] = first_within(offsets[i], drifts[i], 1).value_or(2);
    }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  count_items(state, kCount);
}
BENCHMARK(disc_pair_first_contact)->Name("limit/contact/disc-disc");

}  // namespace
}  // namespace accord::micro
