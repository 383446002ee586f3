// Plans a scene inside this process: what `accord plan` calls.
#pragma once

#include <atomic>
#include <memory>

#include "common/model/plan.h"
#include "common/model/scene.h"
#include "coordinator/planner.h"

namespace accord {

// As plan_with(), with workers on `options.threads` threads of this process: the plan
// is the same for any number of them.
Plan plan(const std::shared_ptr<const Scene>& scene, const PlanOptions& options,
          const ProgressCallback& progress = {}, const std::atomic<bool>* cancel = nullptr);

}  // namespace accord
