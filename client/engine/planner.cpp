#include "client/engine/planner.h"

#include <algorithm>

#include "client/engine/local_crew.h"

namespace accord {

Plan plan(const std::shared_ptr<const Scene>& scene, const PlanOptions& options,
          const ProgressCallback& progress, const std::atomic<bool>* cancel) {
  const CrewFactory on_threads = [&](const CollisionWorld& planning, const CollisionWorld&) {
    return std::make_unique<LocalCrew>(planning, std::max(1U, options.threads));
  };
  return plan_with(on_threads, scene, options, progress, cancel);
}

}  // namespace accord
