#include "coordinator/initial_paths.h"

#include <algorithm>
#include <vector>

#include "coordinator/stopwatch.h"

namespace accord {

std::optional<Outcome> plan_initial_paths(const Scene& scene, Workforce& workforce,
                                          const std::atomic<bool>& stop,
                                          const ProgressCallback& progress,
                                          SubproblemFactory& factory, Schedule& schedule,
                                          PlanningStatistics& statistics) {
  const Stopwatch watch;
  const std::size_t robots = schedule.size();
  std::vector<Resolution> found(robots);
  // In slices, so that progress can be told and a stop is heard.
  constexpr std::size_t kSlice = 64;
  for (std::size_t first = 0; first < robots; first += kSlice) {
    if (progress) progress({Progress::Phase::kInitialPaths, first, 0, 0, 0});
    const std::size_t count = std::min(kSlice, robots - first);
    std::vector<Subproblem> own;
    for (std::size_t i = 0; i < count; ++i) {
      own.push_back(factory.create_initial({static_cast<std::uint32_t>(first + i)}));
    }
    std::ranges::move(workforce.solve(own, stop),
                      found.begin() + static_cast<std::ptrdiff_t>(first));
    if (stop) return stopped_alone(scene, {static_cast<std::uint32_t>(first)});
  }
  for (std::uint32_t id = 0; id < robots; ++id) {
    statistics.effort += found[id].effort;
    if (!found[id].solved) return no_way_alone(scene, {id});
    statistics.lower_bound += found[id].end;
    if (found[id].roadmap_level >= 0) factory.use_roadmap({id}, found[id].roadmap_level);
    schedule.set_initial({id}, std::move(found[id].paths[0]), std::move(found[id].solver));
  }
  statistics.initial_time = watch.seconds();
  return std::nullopt;
}

}  // namespace accord
