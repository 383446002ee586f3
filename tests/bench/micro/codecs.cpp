// Scene and plan files, from and to text in memory. Beside them what the plan's numbers alone take,
// read or written one after the other.
//
// The wire (DDS, Protobuf) is measured here, too, once common/transport exists.
#include <benchmark/benchmark.h>

#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "common/io/plan_file.h"
#include "common/io/scene_file.h"
#include "tests/bench/micro/counters.h"
#include "tests/bench/micro/examples.h"

namespace accord::micro {
namespace {

void count_bytes(benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

void read_scene(benchmark::State& state, const std::string& name) {
  const std::filesystem::path path = example_path(name);
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(parse_scene(text, path.string(), path.parent_path()).scene);
  }
  count_bytes(state, text.size());
}
BENCHMARK_CAPTURE(read_scene, fleet, "fleet-1000")
    ->Name("codec/read-scene/fleet-1000")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(read_scene, arms, "panda-four")
    ->Name("codec/read-scene/panda-four")
    ->Unit(benchmark::kMicrosecond);

const Plan& fleet_plan() {
  static const Plan plan = example_plan(example("fleet-0050"));
  return plan;
}

void write_plan(benchmark::State& state) {
  const Plan& plan = fleet_plan();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(to_json(plan));
  count_bytes(state, to_json(plan).size());
}
BENCHMARK(write_plan)->Name("codec/write-plan/fleet-0050")->Unit(benchmark::kMicrosecond);

void read_plan(benchmark::State& state) {
  const std::string text = to_json(fleet_plan());
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(parse_plan(text, "plan").plan);
  count_bytes(state, text.size());
}
BENCHMARK(read_plan)->Name("codec/read-plan/fleet-0050")->Unit(benchmark::kMicrosecond);

// Times and configurations of all waypoints.
std::vector<double> numbers_of(const Plan& plan) {
  std::vector<double> out;
  for (const RobotPlan& robot : plan.robots) {
    for (std::size_t i = 0; i < robot.trajectory.size(); ++i) {
      out.push_back(robot.trajectory.time(i));
      const ConfigurationView q = robot.trajectory.configuration(i);
      out.insert(out.end(), q.begin(), q.end());
    }
  }
  return out;
}

std::string text_of(const std::vector<double>& numbers) {
  std::string text;
  std::array<char, 32> buffer;
  for (const double x : numbers) {
    text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), x).ptr);
    text += ' ';
  }
  return text;
}

void write_numbers(benchmark::State& state) {
  const std::vector<double> numbers = numbers_of(fleet_plan());
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(text_of(numbers));
  count_bytes(state, text_of(numbers).size());
}
BENCHMARK(write_numbers)->Name("limit/codec/write-plan")->Unit(benchmark::kMicrosecond);

void read_numbers(benchmark::State& state) {
  const std::string text = text_of(numbers_of(fleet_plan()));
  for ([[maybe_unused]] auto _ : state) {
    const char* const end = text.data() + text.size();
    double x = 0;
    for (const char* at = text.data(); at < end;) at = std::from_chars(at, end, x).ptr + 1;
    benchmark::DoNotOptimize(x);
  }
  count_bytes(state, text.size());
}
BENCHMARK(read_numbers)->Name("limit/codec/read-plan")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace accord::micro
