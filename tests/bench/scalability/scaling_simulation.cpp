// What a planning run would take with any number of hands: replayed in virtual time from what each
// attempt costs on this machine. Prints JSON; tests/bench/scaling makes a table of it.
//
//   scaling_simulation SCENE.yaml SEED DELAY_US HANDS...
#include <fmt/format.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "common/geometry/tolerances.h"
#include "common/io/scene_file.h"
#include "common/planning/method_names.h"
#include "coordinator/arc.h"
#include "coordinator/foreman.h"
#include "tests/bench/scalability/cpu_clock.h"
#include "tests/bench/scalability/simulated_crew.h"

namespace accord::bench {
namespace {

struct Bench {
  explicit Bench(const std::shared_ptr<const Scene>& of, std::uint64_t of_seed)
      : scene(of),
        seed(of_seed),
        planning(scene, kPlanningMargin),
        detection(scene, 0.5 * kPlanningMargin),
        book(planning) {}

  // One row of the table.
  std::string run(const Cluster& cluster) {
    auto crew = std::make_unique<SimulatedCrew>(book, cluster);
    const SimulatedCrew& watched = *crew;
    Foreman foreman(std::move(crew), default_solver_names());
    const std::atomic<bool> stop{false};
    Arc arc(planning, detection, seed, foreman, stop, {});
    const Outcome outcome = arc.run();
    const double end = watched.now();
    const SimulatedCrew::Account& account = watched.account();
    const PlanningStatistics& statistics = arc.statistics();
    return fmt::format(
        R"({{"hands": {}, "caller_is_free": {}, "solved": {}, "seconds": {:.6f}, "caller": {:.6f}, )"
        R"("busy": {:.6f}, "longest": {:.6f}, "attempts": {}, "ahead": {}, )"
        R"("rounds": {}, "subproblems": {}}})",
        cluster.hands, cluster.caller_is_free, outcome.status == PlanStatus::kSolved, end,
        account.caller, account.busy, account.longest, account.attempts, account.ahead,
        statistics.rounds, statistics.subproblems);
  }

  std::shared_ptr<const Scene> scene;
  std::uint64_t seed;
  CollisionWorld planning, detection;
  CostBook book;
};

int main(int argc, char** argv) {
  if (argc < 5) {
    std::cerr << "usage: scaling_simulation SCENE.yaml SEED DELAY_US HANDS...\n";
    return 2;
  }
  const auto loaded = load_scene(argv[1]);
  if (!loaded.scene) {
    std::cerr << "scaling_simulation: no such scene: " << argv[1] << "\n";
    return 2;
  }
  Bench bench(loaded.scene, std::strtoull(argv[2], nullptr, 10));
  Cluster cluster;
  cluster.delay = 1e-6 * std::strtod(argv[3], nullptr);
  const char* separator = "[";
  const auto print = [&](const std::string& row) {
    std::cout << separator << row << std::flush;
    separator = ",\n ";
  };
  for (int i = 4; i < argc; ++i) {
    cluster.hands = std::strtoull(argv[i], nullptr, 10);
    cluster.caller_is_free = false;
    bench.run(cluster);  // costs that are not known yet are looked up here
    print(bench.run(cluster));
  }
  cluster.caller_is_free = true;
  print(bench.run(cluster));
  std::cout << "]\n";
  return 0;
}

}  // namespace
}  // namespace accord::bench

int main(int argc, char** argv) {
  return accord::bench::main(argc, argv);
}
