#include "client/engine/replay.h"

#include <algorithm>

#include "common/geometry/tolerances.h"
#include "common/planning/resolution_check.h"
#include "coordinator/stopwatch.h"
#include "coordinator/watchdog.h"
#include "worker/solver.h"
#include "worker/worker.h"

namespace accord {
namespace {

Replay::Outcome outcome_of(const Resolution& resolution, bool is_stopped) {
  if (resolution.solved) return Replay::Outcome::kSolved;
  if (is_stopped) return Replay::Outcome::kStopped;
  return resolution.improves() ? Replay::Outcome::kImproved : Replay::Outcome::kExhausted;
}

}  // namespace

tl::expected<Replay, std::string> replay(const RecordedTask& task, std::optional<double> timeout,
                                         const std::atomic<bool>* cancel) {
  const auto is_unknown = [](const std::string& name) { return make_solver(name) == nullptr; };
  const auto unknown = std::ranges::find_if(task.solvers, is_unknown);
  if (unknown != task.solvers.end()) {
    return tl::unexpected("hierarchy: no solver \"" + *unknown + "\"");
  }
  const CollisionWorld planning(task.scene, kPlanningMargin);
  const Worker worker(planning);
  Replay out;
  {
    const Watchdog watchdog(timeout, cancel);
    const Stopwatch watch;
    out.resolution = worker.solve(task.subproblem, task.solvers, watchdog.stop());
    out.seconds = watch.seconds();
    out.outcome = outcome_of(out.resolution, watchdog.stop());
  }
  const CollisionWorld detection(task.scene, kDetectionMargin);
  if (auto fault = resolution_fault(detection, task.subproblem, out.resolution)) {
    out.outcome = Replay::Outcome::kRefused;
    out.fault = std::move(*fault);
  }
  return out;
}

}  // namespace accord
