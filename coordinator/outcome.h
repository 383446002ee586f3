// How a run of ARC ended and, where it found no plan, the sentence that says why: it names the
// robots and the place. Pure; thread safe.
#pragma once

#include <cstdint>
#include <string>

#include "common/model/plan.h"
#include "common/model/scene.h"
#include "common/planning/conflict.h"
#include "common/planning/subproblem.h"
#include "coordinator/conflict_board.h"

namespace accord {

struct Outcome {
  PlanStatus status;    // solved, infeasible, timeout (a limit of counts) or cancelled (stopped)
  std::string message;  // why not solved; of a cancelled one, how far it had come
};

// A robot has no path even if nobody else is there.
Outcome no_way_alone(const Scene& scene, RobotId robot);

// Nothing was left to grow: the subproblem was the whole problem of its robots.
Outcome unresolved(const Scene& scene, const Conflict& conflict, const Subproblem& subproblem);

// Resolutions only pushed the same conflicts ahead of themselves. Requires: a conflict is left.
Outcome given_up(const Scene& scene, const ConflictBoard& board, std::uint64_t resolutions);

// Stopped from outside while robots from `next` on had no paths yet, or with conflicts left.
Outcome stopped_alone(const Scene& scene, RobotId next);
Outcome stopped(const Scene& scene, const ConflictBoard& board);

}  // namespace accord
