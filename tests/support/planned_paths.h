// The paths that ARC plans with a given workforce: what must not depend on who does the work.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "client/engine/local_crew.h"
#include "common/geometry/tolerances.h"
#include "common/io/plan_file.h"
#include "common/io/scene_file.h"
#include "common/planning/method_names.h"
#include "coordinator/arc.h"
#include "coordinator/foreman.h"
#include "coordinator/planner.h"

namespace accord::testing {

inline std::vector<Trajectory> planned_paths(const std::shared_ptr<const Scene>& scene,
                                             Workforce& workforce) {
  const CollisionWorld planning(scene, kPlanningMargin);
  const CollisionWorld detection(scene, kDetectionMargin);
  const std::atomic<bool> stop{false};
  Arc arc(planning, detection, 1, workforce, stop, {});
  const Outcome outcome = arc.run();
  EXPECT_EQ(outcome.status, PlanStatus::kSolved) << outcome.message;
  std::vector<Trajectory> paths;
  for (std::uint32_t id = 0; id < scene->robots.size(); ++id) {
    paths.push_back(arc.schedule().path({id}));
  }
  return paths;
}

inline std::vector<Trajectory> paths_planned_in_process(const std::shared_ptr<const Scene>& scene) {
  const CollisionWorld world(scene, kPlanningMargin);
  Foreman workforce(std::make_unique<LocalCrew>(world, 1), default_solver_names());
  return planned_paths(scene, workforce);
}

// The whole plan with its statistics, but for what the clock says.
inline std::string planned_bytes(const std::shared_ptr<const Scene>& scene,
                                 const CrewFactory& make_crew) {
  const Plan plan = plan_with(make_crew, scene, {});
  EXPECT_EQ(plan.status, PlanStatus::kSolved) << plan.message;
  return canonical_bytes(plan);
}

inline std::string bytes_planned_in_process(const std::shared_ptr<const Scene>& scene) {
  return planned_bytes(scene, [](const CollisionWorld& planning, const CollisionWorld&) {
    return std::make_unique<LocalCrew>(planning, 1);
  });
}

// One of scenes/.
inline std::shared_ptr<const Scene> example_scene(const std::string& name) {
  return load_scene(ACCORD_SOURCE_DIR "/scenes/" + name + ".yaml").scene;
}

}  // namespace accord::testing
