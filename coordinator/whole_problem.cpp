#include "coordinator/whole_problem.h"

#include <stdexcept>

#include "coordinator/conflict_board.h"
#include "coordinator/initial_paths.h"
#include "coordinator/stopwatch.h"

namespace accord {

WholeProblem::WholeProblem(const CollisionWorld& planning, const CollisionWorld& detection,
                           std::uint64_t seed, Workforce& workforce, const std::atomic<bool>& stop,
                           ProgressCallback progress)
    : planning_(planning),
      detection_(detection),
      workforce_(workforce),
      stop_(stop),
      progress_(std::move(progress)),
      factory_(planning, seed),
      schedule_(std::make_shared<const Scene>(planning.scene())) {}

Outcome WholeProblem::run() {
  if (auto failed = plan_initial_paths(planning_.scene(), workforce_, stop_, progress_, factory_,
                                       schedule_, statistics_)) {
    return *failed;
  }
  const Stopwatch watch;
  const ConflictBoard board(detection_, schedule_);
  statistics_.conflicts_found = board.size();
  statistics_.pair_checks = board.pair_checks();
  if (board.empty()) return {PlanStatus::kSolved, ""};
  if (progress_) {
    progress_({Progress::Phase::kConflicts, schedule_.size(), statistics_.conflicts_found, 0, 0});
  }
  Outcome outcome = solve(*board.conflicts().begin(), stopped(planning_.scene(), board));
  statistics_.conflict_time = watch.seconds();
  return outcome;
}

Outcome WholeProblem::solve(const Conflict& first, const Outcome& when_stopped) {
  const Subproblem subproblem = factory_.create_whole(schedule_);
  const Resolution resolution = workforce_.solve({subproblem}, stop_).front();
  ++statistics_.rounds;
  ++statistics_.subproblems;
  statistics_.effort += resolution.effort;
  if (!resolution.solved) {
    ++statistics_.exhausted;
    return stop_ ? when_stopped : unresolved(planning_.scene(), first, subproblem);
  }
  if (!schedule_.commit(subproblem, resolution)) {
    throw std::logic_error(resolution.solver + " returned paths that do not fit the problem");
  }
  ++statistics_.solved_by[resolution.solver];
  statistics_.conflicts_resolved = statistics_.conflicts_found;
  return {PlanStatus::kSolved, ""};
}

}  // namespace accord
