// Plans a scene, from the scene to a proven plan, inside this process: what `accord plan` calls.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/model/plan.h"
#include "common/model/scene.h"
#include "coordinator/progress.h"

namespace accord {

struct PlanOptions {
  std::string method = "arc";  // of method_names()
  std::uint64_t seed = 1;
  std::optional<double> timeout;     // s, wall clock; it can only end a request, never shape a plan
  unsigned workers = 1;              // threads that solve; changes nothing but the time it takes
  std::vector<std::string> solvers;  // the hierarchy, in order; empty: the default one.
                                     // Only ARC has a hierarchy
};

// "arc", and the baselines, which put the whole problem to one solver: "decoupled-prm",
// "composite-prm", "composite-rrt-connect", "cbs-mp".
const std::vector<std::string>& method_names();

// Names of the solvers that PlanOptions::solvers may hold, and of those it stands for when empty.
const std::vector<std::string>& solver_names();
const std::vector<std::string>& default_solvers();

// `progress` is called from the thread that called plan(), at most every 50 ms and at each change
// of phase.
// Returns a plan with status solved that the verifier has proved, or one whose message says why
// there is none (infeasible, timeout, cancelled when `cancel` becomes true). A plan that the
// verifier refutes is a bug of the planner: std::logic_error that carries the verifier's words.
// Requires: options hold names of method_names() and solver_names() only; the scene passed io's
// checks.
Plan plan(const std::shared_ptr<const Scene>& scene, const PlanOptions& options,
          const ProgressCallback& progress = {}, const std::atomic<bool>* cancel = nullptr);

}  // namespace accord
