#include "worker/decoupled_prm.h"

#include <algorithm>

#include "worker/decoupled_roadmaps.h"
#include "worker/prioritized_search.h"

namespace accord {
namespace {

constexpr std::size_t kSmallTeam = 4;
// Samples a robot adds before a large team tries again.
constexpr std::size_t kFirstSamples = 96;

}  // namespace

Resolution DecoupledPrm::do_solve(const Workspace& workspace, const Subproblem& subproblem,
                                  const std::atomic<bool>& stop) const {
  DecoupledRoadmaps roadmaps(workspace, subproblem);
  Effort effort;
  // Batches grow: most conflicts need a handful of places to step aside to.
  const bool is_small = subproblem.tasks.size() <= kSmallTeam;
  std::size_t batch = std::min(kFirstSamples, subproblem.limits.decoupled_samples);
  if (is_small) batch = (batch + 5) / 6;
  for (std::size_t added = 0; added < subproblem.limits.decoupled_samples && !stop;) {
    roadmaps.add_samples(batch);
    added += batch;
    batch *= 2;
    Resolution resolution = prioritized_search(workspace.world(), subproblem, roadmaps, stop);
    effort += resolution.effort;
    resolution.effort = effort;
    resolution.effort.samples = roadmaps.samples();
    resolution.solver = kName;
    if (resolution.solved || resolution.improves()) return resolution;
  }
  Resolution exhausted;
  exhausted.effort = effort;
  exhausted.effort.samples = roadmaps.samples();
  return exhausted;
}

}  // namespace accord
