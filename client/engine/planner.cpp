#include "client/engine/planner.h"

#include <algorithm>

#include "client/engine/local_workforce.h"

namespace accord {

Plan plan(const std::shared_ptr<const Scene>& scene, const PlanOptions& options,
          const ProgressCallback& progress, const std::atomic<bool>* cancel) {
  const WorkforceFactory on_threads = [&](const CollisionWorld& planning, const CollisionWorld&,
                                          const std::vector<std::string>& solvers) {
    return std::make_unique<LocalWorkforce>(planning, solvers, std::max(1U, options.threads));
  };
  return plan_with(on_threads, scene, options, progress, cancel);
}

}  // namespace accord
