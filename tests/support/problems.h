// Subproblems with known difficulties, for whoever tests or measures solvers.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "common/planning/region.h"
#include "common/planning/subproblem.h"
#include "tests/support/scenes.h"

namespace accord::testing {

// A scene with its robots' straight ways as one subproblem.
struct Problem {
  std::shared_ptr<const Scene> scene;
  Subproblem subproblem;
};

inline Problem whole_problem(std::shared_ptr<const Scene> scene, std::size_t members) {
  Subproblem subproblem;
  subproblem.seed = 5;
  subproblem.to = 12;
  subproblem.horizon = 60;
  subproblem.whole = true;
  for (std::uint32_t id = 0; id < scene->robots.size(); ++id) {
    const Robot& robot = scene->robot({id});
    const Trajectory guide = path({{0, robot.start}, {12, robot.goal}});
    if (id < members) {
      subproblem.tasks.push_back(
          {{id}, 1, robot.start, 12, robot.goal, whole_region(*scene, {id}), guide, {}, -1});
    } else {
      subproblem.outsiders.push_back({{id}, 1, guide, subproblem.horizon});
    }
  }
  return {std::move(scene), std::move(subproblem)};
}

inline Problem crossing_discs() {
  return whole_problem(
      SceneBuilder(-8, -8, 8, 8).disk(0.5, {-5, 0}, {5, 0}).disk(0.5, {0, -5}, {0, 5}).build(), 2);
}

inline Problem swapping_discs_and_a_passer_by() {
  return whole_problem(SceneBuilder(-8, -8, 8, 8)
                           .disk(0.5, {-5, 0}, {5, 0})
                           .disk(0.5, {5, 0}, {-5, 0})
                           .disk(0.5, {-3, 6}, {3, -6})
                           .build(),
                       2);
}

// Neither can yield without the other: each has to back out of the corridor first.
inline Problem discs_in_a_corridor_with_a_pocket() {
  return whole_problem(SceneBuilder(-6, -1, 6, 3)
                           .box(-6, 0.6, -0.6, 3)
                           .box(0.6, 0.6, 6, 3)
                           .box(-6, -1, 6, -0.6)
                           .disk(0.5, {-4, 0}, {4, 0})
                           .disk(0.5, {4, 0}, {-4, 0})
                           .build(),
                       2);
}

// The same with a niche instead of a pocket, one that leaves the disc 5 mm on each side.
inline Problem discs_in_a_corridor_with_a_niche() {
  return whole_problem(SceneBuilder(-6, -0.6, 6, 2)
                           .box(-6, 0.6, -0.505, 2)
                           .box(0.505, 0.6, 6, 2)
                           .disk(0.5, {-4, 0}, {4, 0})
                           .disk(0.5, {4, 0}, {-4, 0})
                           .build(),
                       2);
}

inline Problem swapping_carts() {
  const auto cart = cart_model(1.0, 0.6);
  return whole_problem(SceneBuilder(-6, -6, 6, 6)
                           .robot(cart, {-3, 0, 0}, {3, 0, 0})
                           .robot(cart, {3, 0, 3.1}, {-3, 0, 3.1})
                           .build(),
                       2);
}

inline Problem arms_that_change_sides() {
  const auto arm = planar_arm_model({1, 0.8});
  Pose across = Pose::Identity();
  across.translation() = Vec3(2.2, 0, 0);
  across.linear() = Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()).toRotationMatrix();
  return whole_problem(SceneBuilder(-3, -3, 5, 3)
                           .robot(arm, {0.8, 0}, {-0.8, 0})
                           .robot(arm, {0.8, 0}, {-0.8, 0}, across)
                           .build(),
                       2);
}

// Many discs that change places across a circle, and look 9 s ahead.
inline Problem crowd() {
  SceneBuilder builder(-8, -8, 8, 8);
  for (int i = 0; i < 11; ++i) {
    const double angle = 2 * std::numbers::pi * i / 11;
    const double x = 6 * std::cos(angle), y = 6 * std::sin(angle);
    builder.disk(0.4, {x, y}, {-x, -y});
  }
  Problem problem = whole_problem(builder.build(), 10);
  problem.subproblem.clear_until = problem.subproblem.horizon = 9;
  problem.subproblem.outsiders.front().until = 9;
  return problem;
}

inline Problem crowd_in_lockstep() {
  Problem problem = crowd();
  problem.subproblem.outsiders.clear();
  problem.subproblem.clear_until = std::numeric_limits<double>::infinity();
  problem.subproblem.lockstep = true;
  return problem;
}

}  // namespace accord::testing
