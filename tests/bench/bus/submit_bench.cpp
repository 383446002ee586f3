// What it costs to plan through the public topics: the same request planned in this process, and by
// a coordinator and workers that are warm, in turns; both with as many threads.
//
//   submit_bench SCENE [RUNS [THREADS]]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "tests/support/service_processes.h"

namespace accord::testing {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

int run(const std::string& scene, int runs, unsigned threads) {
  ServiceProcesses service;
  service.start_coordinator();
  service.start_worker(threads);
  PlanRequest request = request_for_scene(scene).request;
  request.id = "warm-up";
  if (!service.plan(request)) {
    std::cerr << "submit_bench: no plan\n";
    return 1;
  }
  FleetManager manager(service.port(), {});
  const std::atomic<bool> stop{false};
  PlanOptions options;
  options.threads = threads;
  std::vector<double> here, there, more;
  for (int i = 0; i < runs; ++i) {
    auto begin = Clock::now();
    // As `accord plan` does from the file on: reading and checking the scene are part of both.
    const Plan plan = accord::plan(load_scene(scene).scene, options);
    here.push_back(milliseconds_since(begin));
    request.id = "run-" + std::to_string(i);
    begin = Clock::now();
    const auto answer = manager.plan(request, {}, stop);
    there.push_back(milliseconds_since(begin));
    more.push_back(there.back() - here.back());
    if (!answer || canonical_bytes(*answer) != canonical_bytes(plan)) {
      std::cerr << "submit_bench: another plan\n";
      return 1;
    }
  }
  std::cout << fmt::format(
      "in process {:.2f} ms, through topics {:.2f} ms, {:+.2f} ms (medians of {} runs, {} "
      "threads)\n",
      median(here), median(there), median(more), runs, threads);
  return 0;
}

}  // namespace
}  // namespace accord::testing

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: submit_bench SCENE [RUNS [THREADS]]\n";
    return 2;
  }
  const int runs = argc > 2 ? std::atoi(argv[2]) : 101;
  const int threads = argc > 3 ? std::atoi(argv[3]) : 1;
  return accord::testing::run(argv[1], std::max(1, runs),
                              static_cast<unsigned>(std::max(1, threads)));
}
