// The search for conflicts among 1,000 robots: scenes/fleet-1000.yaml, everyone straight to its
// goal at 1 m/s, racks or not. Beside it a bare loop over all 499,500 pairs that decides the same
// of each, exactly, as long as both move: what grid, versions and exact times have to be worth.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "common/planning/conflict.h"
#include "common/planning/schedule.h"
#include "coordinator/conflict_board.h"
#include "coordinator/space_time_grid.h"
#include "tests/bench/micro/counters.h"
#include "tests/bench/micro/examples.h"

namespace accord::micro {
namespace {

double length(const Robot& robot) {
  return std::hypot(robot.goal[0] - robot.start[0], robot.goal[1] - robot.start[1]);
}

struct Fleet {
  std::shared_ptr<const Scene> scene = example("fleet-1000");
  CollisionWorld world{scene, kPlanningMargin};
  Schedule schedule{scene};

  Fleet() {
    for (std::uint32_t r = 0; r < size(); ++r) {
      const Robot& robot = scene->robot({r});
      Trajectory path(2);
      path.append(0, robot.start);
      if (length(robot) > 0) path.append(length(robot), robot.goal);
      schedule.set_initial({r}, std::move(path), "straight");
    }
  }
  std::size_t size() const { return scene->robots.size(); }
};

void scan_all(benchmark::State& state) {
  const Fleet fleet;
  std::size_t conflicts = 0;
  std::uint64_t checks = 0;
  {
    const DistanceRate rate(state, fleet.world);
    for ([[maybe_unused]] auto _ : state) {
      ConflictBoard board(fleet.world, fleet.schedule);
      board.look_at_all();
      conflicts = board.size();
      checks = board.pair_checks();
    }
  }
  count_items(state, fleet.size());
  state.counters["conflicts"] = static_cast<double>(conflicts);
  state.counters["pair_checks"] = static_cast<double>(checks);
}
BENCHMARK(scan_all)->Name("conflicts/scan-1000")->Unit(benchmark::kMillisecond);

// One robot's path anew from its start on, as after a commit.
void rescan_one(benchmark::State& state) {
  const Fleet fleet;
  ConflictBoard board(fleet.world, fleet.schedule);
  board.look_at_all();
  std::uint32_t robot = 0;
  for ([[maybe_unused]] auto _ : state) {
    board.update({{robot}}, 0);
    robot = (robot + 1) % static_cast<std::uint32_t>(fleet.size());
  }
  count_items(state, 1);
}
BENCHMARK(rescan_one)->Name("conflicts/rescan-1-of-1000")->Unit(benchmark::kMicrosecond);

// Everyone's path filed, and everyone's neighbours asked for in every slab, nobody compared.
void broad_phase(benchmark::State& state) {
  constexpr double kSlab = 1.5, kCell = 3;  // s, m: about what ConflictBoard chooses
  const Aabb area{Vec3(-100, -100, 0), Vec3(100, 100, 0)};
  const Fleet fleet;
  std::size_t near = 0;
  for ([[maybe_unused]] auto _ : state) {
    SpaceTimeGrid grid(fleet.world, kSlab, area, kCell);
    for (std::uint32_t r = 0; r < fleet.size(); ++r) grid.place({r}, fleet.schedule.path({r}), 0);
    std::vector<RobotId> neighbours;
    near = 0;
    for (std::uint32_t r = 0; r < fleet.size(); ++r) {
      for (std::size_t slab = 0; slab < grid.slabs(); ++slab) {
        grid.neighbours({r}, slab, neighbours);
        near += neighbours.size();
      }
    }
    benchmark::DoNotOptimize(near);
  }
  count_items(state, fleet.size());
  state.counters["neighbours"] = static_cast<double>(near);
}
BENCHMARK(broad_phase)->Name("conflicts/grid-1000")->Unit(benchmark::kMillisecond);

// Exact times of first contact, pair by pair, no broad phase: what one look at a pair costs.
void all_pairs(benchmark::State& state) {
  const Fleet fleet;
  const auto first = static_cast<std::uint32_t>(fleet.size() / 2);
  for ([[maybe_unused]] auto _ : state) {
    for (std::uint32_t r = 0; r < first; ++r) {
      benchmark::DoNotOptimize(earliest_contact(fleet.world, {r}, fleet.schedule.path({r}), {first},
                                                fleet.schedule.path({first}), 0, 1e6));
    }
  }
  count_items(state, first);
}
BENCHMARK(all_pairs)->Name("conflicts/earliest-contact");

struct Straight {
  std::vector<double> x, y, vx, vy, end;  // m, m/s, s

  explicit Straight(const Fleet& fleet) {
    for (const Robot& robot : fleet.scene->robots) {
      const double way = std::max(length(robot), 1e-9);
      x.push_back(robot.start[0]);
      y.push_back(robot.start[1]);
      vx.push_back((robot.goal[0] - robot.start[0]) / way);
      vy.push_back((robot.goal[1] - robot.start[1]) / way);
      end.push_back(way);
    }
  }
};

void bare_all_pairs(benchmark::State& state) {
  const Fleet fleet;
  const Straight robots(fleet);
  const std::size_t n = fleet.size();
  const double keep = 2 * *fleet.world.radius({0});
  std::vector<double> slack(n);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < n; ++i) {
      const double xi = robots.x[i], yi = robots.y[i], ui = robots.vx[i], vi = robots.vy[i];
      for (std::size_t j = i + 1; j < n; ++j) {
        const double dx = robots.x[j] - xi, dy = robots.y[j] - yi;
        const double du = robots.vx[j] - ui, dv = robots.vy[j] - vi;
        const double a = du * du + dv * dv + 1e-12;
        const double until = std::min(robots.end[i], robots.end[j]);
        const double t = std::min(until, std::max(0.0, -(dx * du + dy * dv) / a));
        const double px = dx + t * du, py = dy + t * dv;
        slack[j] = px * px + py * py - keep * keep;
      }
      benchmark::DoNotOptimize(slack.data());
      benchmark::ClobberMemory();
    }
  }
  count_items(state, n);
  const std::size_t pairs = n * (n - 1) / 2;
  state.counters["pair_checks"] = static_cast<double>(pairs);
}
BENCHMARK(bare_all_pairs)->Name("limit/conflicts/scan-1000")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace accord::micro
