// Each robot's own path, as if it were alone. (Alg. 1, lines 2 to 5)
#pragma once

#include <atomic>
#include <optional>

#include "common/planning/schedule.h"
#include "coordinator/method.h"
#include "coordinator/progress.h"
#include "coordinator/subproblem_factory.h"
#include "coordinator/workforce.h"

namespace accord {

// Has the workforce plan all robots' own paths and enters them into the schedule; tells the factory
// whose roadmaps were needed; adds to effort, lower bound and initial time. nullopt: all have one.
std::optional<Outcome> plan_initial_paths(const Scene& scene, Workforce& workforce,
                                          const std::atomic<bool>& stop,
                                          const ProgressCallback& progress,
                                          SubproblemFactory& factory, Schedule& schedule,
                                          PlanningStatistics& statistics);

}  // namespace accord
