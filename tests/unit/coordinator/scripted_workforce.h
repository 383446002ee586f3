// A workforce that does what a test tells it, so that methods can be tested without solvers, and
// what tests of methods share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "coordinator/outcome.h"
#include "coordinator/workforce.h"
#include "tests/support/scenes.h"

namespace accord::testing {

// Robots on their own go straight; what becomes of teams is up to the test.
class ScriptedWorkforce final : public Workforce {
 public:
  std::function<Resolution(const Subproblem&)> alone = straight;
  std::function<Resolution(const Subproblem&)> team = exhausted;
  std::vector<std::size_t> rounds;  // how many teams were to be solved at once

  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>&, const Foresight&) override {
    std::vector<Resolution> out;
    for (const Subproblem& subproblem : subproblems) {
      out.push_back(subproblem.tasks.size() == 1 ? alone(subproblem) : team(subproblem));
    }
    if (subproblems.front().tasks.size() > 1) rounds.push_back(subproblems.size());
    return out;
  }

  static Resolution exhausted(const Subproblem&) { return {}; }

  static Resolution straight(const Subproblem& subproblem) {
    Resolution out = solved(subproblem, 0);
    const Task& task = subproblem.tasks[0];
    out.end = std::hypot(task.goal[0] - task.start[0], task.goal[1] - task.start[1]);
    out.paths = {path({{0, task.start}, {out.end, task.goal}})};
    return out;
  }

  // Everyone keeps to its path, but for the first, which waits at its start.
  static Resolution solved(const Subproblem& subproblem, double wait) {
    Resolution out;
    out.solved = true;
    out.solver = "script";
    for (const Task& task : subproblem.tasks) {
      Trajectory path(task.goal.size());
      const double delay = out.paths.empty() ? wait : 0;
      path.append(subproblem.from, task.start);
      if (delay > 0) path.append(subproblem.from + delay, task.start);
      if (task.to > subproblem.from) path.append(task.to + delay, task.goal);
      out.end = std::max(out.end, path.end_time());
      out.paths.push_back(std::move(path));
    }
    return out;
  }

  static Resolution unchanged(const Subproblem& subproblem) {
    Resolution out = solved(subproblem, 0);
    for (std::size_t i = 0; i < out.paths.size(); ++i) out.paths[i] = subproblem.tasks[i].guide;
    return out;
  }
};

// Runs a method of planning on scenes, with a scripted workforce.
template <typename MethodType>
class MethodTest : public ::testing::Test {
 protected:
  Outcome run(const SceneBuilder& builder) {
    const auto scene = builder.build();
    planning_.emplace(scene, kPlanningMargin);
    detection_.emplace(scene, kDetectionMargin);
    method_.emplace(*planning_, *detection_, 1, workforce_, stop_, nullptr);
    return method_->run();
  }

  ScriptedWorkforce workforce_;
  std::atomic<bool> stop_{false};
  std::optional<CollisionWorld> planning_, detection_;
  std::optional<MethodType> method_;
};

}  // namespace accord::testing
