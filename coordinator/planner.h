// Plans a scene, from the scene to a proven plan, with whatever crew it is given: what
// `accord plan` and the service have in common.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/model/plan.h"
#include "common/model/scene.h"
#include "coordinator/crew.h"
#include "coordinator/progress.h"

namespace accord {

struct PlanOptions {
  std::string method = "arc";  // of method_names()
  std::uint64_t seed = 1;
  std::optional<double> timeout;     // s, wall clock; it can only end a request, never shape a plan
  unsigned threads = 1;              // for the proof; changes nothing but the time it takes
  std::vector<std::string> solvers;  // the hierarchy, in order; empty: the default one.
                                     // Only ARC has a hierarchy
};

// Makes who carries out the work. The worlds are of the scene, with the margins that planning and
// looking for conflicts keep; they outlive the crew.
using CrewFactory = std::function<std::unique_ptr<Crew>(const CollisionWorld& planning,
                                                        const CollisionWorld& detection)>;

// A plan of the request's identity that says why there is none. The scene may be null: then it is
// not known.
Plan unsolved_plan(const Scene* scene, const PlanOptions& options, PlanStatus status,
                   std::string message);

// `progress` is called from the thread that called plan_with(), at most every 50 ms and at each
// change of phase. Returns a plan with status solved that the verifier has proved, or one whose
// message says why there is none (infeasible, timeout, cancelled when `cancel` becomes true). A
// plan that the verifier refutes is a bug of the planner: std::logic_error that carries the
// verifier's words. What the crew fails of comes through. Thread safe. Requires: options hold
// names of method_names() and local_solver_names() only; the scene passed io's checks.
Plan plan_with(const CrewFactory& crew, const std::shared_ptr<const Scene>& scene,
               const PlanOptions& options, const ProgressCallback& progress = {},
               const std::atomic<bool>* cancel = nullptr);

}  // namespace accord
