#include "coordinator/method.h"

#include <algorithm>
#include <vector>

#include "common/geometry/query_counter.h"
#include "coordinator/stopwatch.h"

namespace accord {
namespace {

double sum_of_costs(const Schedule& schedule) {
  double sum = 0;
  for (std::uint32_t r = 0; r < schedule.size(); ++r) sum += schedule.path({r}).arrival_time();
  return sum;
}

}  // namespace

Method::Method(const CollisionWorld& planning, const CollisionWorld& detection, std::uint64_t seed,
               Workforce& workforce, const std::atomic<bool>& stop, ProgressCallback progress)
    : planning_(planning),
      workforce_(workforce),
      stop_(stop),
      factory_(planning, seed),
      schedule_(std::make_shared<const Scene>(planning.scene())),
      detection_(detection),
      progress_(std::move(progress)) {}

Outcome Method::run() {
  const SeparateCost cost;
  Outcome outcome = plan();
  statistics_.distance_queries = cost.so_far();
  return outcome;
}

Outcome Method::plan() {
  if (auto failed = plan_initial_paths()) return *failed;
  const Stopwatch watch;
  ConflictBoard board(detection_, schedule_);
  Outcome outcome = resolve(board);
  statistics_.conflicts_found = board.found();
  statistics_.pair_checks = board.pair_checks();
  statistics_.conflict_time = watch.seconds();
  return outcome;
}

std::optional<Outcome> Method::plan_initial_paths() {
  const Stopwatch watch;
  const std::size_t robots = schedule_.size();
  const std::uint64_t before = workforce_.asked();
  std::vector<Resolution> found(robots);
  // In slices, so that progress can be told and a stop is heard.
  constexpr std::size_t kSlice = 64;
  for (std::size_t first = 0; first < robots; first += kSlice) {
    report_initial_paths(first);
    const std::size_t count = std::min(kSlice, robots - first);
    std::vector<Subproblem> own;
    for (std::size_t i = 0; i < count; ++i) {
      own.push_back(factory_.create_initial({static_cast<std::uint32_t>(first + i)}));
    }
    std::ranges::move(workforce_.solve(own, stop_, {}),
                      found.begin() + static_cast<std::ptrdiff_t>(first));
    if (stop_) return stopped_alone(scene(), {static_cast<std::uint32_t>(first)});
  }
  for (std::uint32_t id = 0; id < robots; ++id) {
    statistics_.effort += found[id].effort;
    if (!found[id].solved) return no_way_alone(scene(), {id});
    statistics_.lower_bound += found[id].end;
    if (found[id].roadmap_level >= 0) factory_.use_roadmap({id}, found[id].roadmap_level);
    schedule_.set_initial({id}, std::move(found[id].paths[0]), std::move(found[id].solver),
                          before + id + 1);
  }
  statistics_.initial_time = watch.seconds();
  return std::nullopt;
}

void Method::report_initial_paths(std::size_t robots_planned) const {
  if (progress_) progress_({Progress::Phase::kInitialPaths, robots_planned, 0, 0, 0});
}

void Method::report_conflicts(std::size_t conflicts_left) const {
  if (!progress_) return;
  progress_({Progress::Phase::kConflicts, schedule_.size(), statistics_.conflicts_found,
             statistics_.conflicts_resolved, statistics_.rounds, conflicts_left,
             sum_of_costs(schedule_)});
}

}  // namespace accord
