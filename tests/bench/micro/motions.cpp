// Certified checks of motions: one robot among obstacles, and two robots that move at the same
// time. Motions are about as long as the robot, as a roadmap's edges are. "free" is the share of
// motions that are: a proof takes longer than a refutation.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "tests/bench/micro/counters.h"
#include "tests/contract/test_scenes.h"

namespace accord::micro {
namespace {

using test_scenes::at;
using test_scenes::Random;
using Model = std::shared_ptr<const RobotModel>;

constexpr std::size_t kMotions = 256;
constexpr double kHall = 5;  // m: half of its side

struct MotionPair {
  Configuration from;
  Configuration to;
};

// From anywhere to somewhere near, of mobile robots; of arms, a third of a radian in each joint.
std::vector<MotionPair> short_motions(const RobotModel& model, unsigned seed, double span) {
  Random random(seed);
  std::vector<MotionPair> motions;
  for (std::size_t i = 0; i < kMotions; ++i) {
    MotionPair motion{test_scenes::random_configuration(model, random, span), {}};
    motion.to = motion.from;
    const double reach = model.kind == RobotKind::kArm ? 0.33 : 0.8;
    for (std::size_t k = 0; k < model.dof(); ++k) {
      const double moved = motion.from[k] + test_scenes::uniform(random, -reach, reach);
      motion.to[k] = std::clamp(moved, model.dofs[k].lower, model.dofs[k].upper);
    }
    motions.push_back(std::move(motion));
  }
  return motions;
}

// 64 boxes all over a hall, no bounds.
std::shared_ptr<const Scene> hall(const Model& model, bool planar) {
  Random random(7);
  test_scenes::SceneBuilder builder(planar);
  for (int i = 0; i < 64; ++i) {
    const double x = test_scenes::uniform(random, -kHall, kHall);
    const double y = test_scenes::uniform(random, -kHall, kHall);
    const double z = planar ? 0 : test_scenes::uniform(random, -kHall / 2, kHall / 2);
    builder.obstacle(Box{Vec3(0.6, 0.3, 0.6)}, at(x, y, z, 0, 0, 0.1 * i));
  }
  return builder.add(model).build();
}

void among_obstacles(benchmark::State& state, const Model& model, bool planar) {
  const CollisionWorld world(hall(model, planar), kPlanningMargin);
  const std::vector<MotionPair> motions = short_motions(*model, 3, kHall);
  std::size_t free = 0;
  {
    const DistanceRate rate(state, world);
    for ([[maybe_unused]] auto _ : state) {
      free = 0;
      for (const MotionPair& motion : motions) {
        free += world.motion_is_free({0}, motion.from, motion.to) ? 1U : 0U;
      }
      benchmark::DoNotOptimize(free);
    }
  }
  count_items(state, kMotions);
  state.counters["free"] = static_cast<double>(free) / kMotions;
}

// Two robots of a model near each other: mobile ones move about the same place, arms stand 1 m
// apart.
void of_two(benchmark::State& state, const Model& model, bool planar, bool when) {
  const bool arms = model->kind == RobotKind::kArm;
  const auto scene = test_scenes::SceneBuilder(planar)
                         .add(model)
                         .add(model, arms ? at(1, 0) : Pose::Identity())
                         .build();
  const CollisionWorld world(scene, kPlanningMargin);
  const auto a = short_motions(*model, 3, 1.5), b = short_motions(*model, 4, 1.5);
  std::size_t clear = 0;
  {
    const DistanceRate rate(state, world);
    for ([[maybe_unused]] auto _ : state) {
      clear = 0;
      for (std::size_t i = 0; i < kMotions; ++i) {
        const bool is_clear =
            when ? !world.first_contact({0}, {a[i].from, a[i].to, 0, 1}, {1},
                                        {b[i].from, b[i].to, 0, 1})
                 : world.motions_are_clear({0}, a[i].from, a[i].to, {1}, b[i].from, b[i].to);
        clear += is_clear ? 1U : 0U;
      }
      benchmark::DoNotOptimize(clear);
    }
  }
  count_items(state, kMotions);
  state.counters["free"] = static_cast<double>(clear) / kMotions;
}

[[maybe_unused]] const bool kAdded = [] {
  struct Case {
    const char* name;
    Model model;
    bool planar;
  };
  const std::vector<Case> cases{
      {"disc", test_scenes::disk(0.3), true},
      {"ball", test_scenes::ball(0.3), false},
      {"cart", test_scenes::footprint(test_scenes::rectangle(0.8, 0.5)), true},
      {"planar-arm-3", test_scenes::planar_arm(), true},
      {"arm-6", test_scenes::six_joint_arm(), false}};
  for (const Case& of : cases) {
    const std::string name = of.name;
    benchmark::RegisterBenchmark(
        ("motion/" + name + "-obstacles").c_str(),
        [of](benchmark::State& state) { among_obstacles(state, of.model, of.planar); });
    for (const bool when : {false, true}) {
      benchmark::RegisterBenchmark(
          ((when ? "contact/" : "motion/") + name + "-" + name).c_str(),
          [of, when](benchmark::State& state) { of_two(state, of.model, of.planar, when); });
    }
  }
  return true;
}();

}  // namespace
}  // namespace accord::micro
