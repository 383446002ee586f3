// CollisionWorld's proofs about motions, held against dense sampling with textbook geometry: what
// is proved free never samples as a contact, and where a proof ends there is a contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "tests/contract/reference_geometry.h"
#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using namespace test_scenes;

constexpr double kHalfPi = std::numbers::pi / 2;

// Proofs may end this far (m) from what is required.
constexpr double kTight = kPlanningMargin + 3 * kContactResolution + 1e-8;

struct Scenario {
  std::string name;
  std::function<std::shared_ptr<const Scene>()> make;
  double span;  // of start positions and headings
  double step;  // of motions, per degree of freedom
  int motions;
  int samples;
};

std::ostream& operator<<(std::ostream& out, const Scenario& s) {
  return out << s.name;
}

std::string name_of(const testing::TestParamInfo<Scenario>& scenario) {
  return scenario.param.name;
}

Configuration moved(const Configuration& q, Random& random, double step) {
  Configuration to = q;
  for (double& value : to) value += uniform(random, -step, step);
  return to;
}

// ---- Two robots ----

class TwoRobots : public testing::TestWithParam<Scenario> {};

TEST_P(TwoRobots, KeepApartAsLongAsProvedAndNoLonger) {
  const Scenario& scenario = GetParam();
  const auto scene = scenario.make();
  const CollisionWorld world(scene, kPlanningMargin);
  const RobotId a{0};
  const RobotId b{1};
  Random random(7);
  int free = 0;
  int contacts = 0;
  int at_once = 0;
  for (int k = 0; k < scenario.motions; ++k) {
    const auto a0 = random_configuration(*scene->robots[0].model, random, scenario.span);
    const auto b0 = random_configuration(*scene->robots[1].model, random, scenario.span);
    const auto a1 = moved(a0, random, scenario.step);
    const auto b1 = moved(b0, random, k % 7 == 0 ? 0.0 : scenario.step);
    const Motion motion_a{a0, a1, 2, 5};
    const Motion motion_b{b0, b1, 2, 5};
    const auto contact = world.first_contact(a, motion_a, b, motion_b);
    const auto distance_at = [&](double u) {
      return reference::robot_distance(*scene, a, reference::between(a0, a1, u), b,
                                       reference::between(b0, b1, u));
    };
    const double until = contact ? (*contact - 2) / 3 : 1.0;
    ASSERT_GE(until, 0);
    ASSERT_LE(until, 1);
    for (int i = 0; i < scenario.samples; ++i) {
      const double u = until * i / scenario.samples;
      if (contact && until == 0) break;
      ASSERT_GT(distance_at(u).upper, scene->clearance) << "motion " << k << " at " << u;
    }
    if (contact) {
      const auto at_end = distance_at(until);
      ASSERT_LT(at_end.lower, scene->clearance + kTight) << "motion " << k << " at " << until;
      contacts += until > 0;
      at_once += until == 0;
      if (until == 0) {
        ASSERT_FALSE(world.are_clear(a, a0, b, b0)) << "motion " << k;
      }
    } else {
      ++free;
      ASSERT_GT(distance_at(1).upper, scene->clearance) << "motion " << k;
    }
    const auto other_way = world.first_contact(b, motion_b, a, motion_a);
    ASSERT_EQ(contact.has_value(), other_way.has_value()) << "motion " << k;
  }
  // The scenario is worth its name.
  EXPECT_GT(free, scenario.motions / 10);
  EXPECT_GT(contacts, scenario.motions / 100);
  EXPECT_GT(at_once + contacts, scenario.motions / 30);
}

INSTANTIATE_TEST_SUITE_P(
    Planar, TwoRobots,
    testing::Values(
        Scenario{
            "discs",
            [] { return SceneBuilder(true).clearance(0.1).add(disk(0.5)).add(disk(0.3)).build(); },
            2, 4, 400, 50},
        Scenario{"rectangles",
                 [] {
                   return SceneBuilder(true)
                       .clearance(0.05)
                       .add(footprint(rectangle(1.4, 0.7)))
                       .add(footprint(rectangle(0.8, 0.6)))
                       .build();
                 },
                 2, 3, 300, 40},
        Scenario{"ells",
                 [] {
                   return SceneBuilder(true)
                       .clearance(0.02)
                       .add(footprint(ell()))
                       .add(footprint(ell()))
                       .build();
                 },
                 1.5, 2, 100, 30},
        Scenario{"disc_and_ell",
                 [] {
                   return SceneBuilder(true)
                       .clearance(0.02)
                       .add(disk(0.3))
                       .add(footprint(ell()))
                       .build();
                 },
                 1.5, 3, 200, 30},
        Scenario{"planar_arms",
                 [] {
                   return SceneBuilder(true)
                       .add(planar_arm(), at(-1.5, 0, 0, 0, 0, 0.4))
                       .add(planar_arm(), at(1.5, 0.3, 0, 0, 0, 2.5))
                       .build();
                 },
                 0, 0.5, 200, 30},
        Scenario{"planar_arms_far",
                 [] {
                   return SceneBuilder(true)
                       .clearance(0.03)
                       .add(planar_arm(), at(-2, 0))
                       .add(planar_arm(), at(2, 0, 0, std::numbers::pi))  // upside down
                       .build();
                 },
                 0, 3, 300, 100},
        Scenario{
            "arm_and_disc",
            [] {
              return SceneBuilder(true).clearance(0.03).add(planar_arm()).add(disk(0.3)).build();
            },
            3, 1, 200, 30}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Spatial, TwoRobots,
    testing::Values(
        Scenario{
            "balls",
            [] { return SceneBuilder(false).clearance(0.1).add(ball(0.5)).add(ball(0.3)).build(); },
            1.5, 3, 400, 50},
        Scenario{"six_joint_arms",
                 [] {
                   return SceneBuilder(false)
                       .clearance(0.01)
                       .add(six_joint_arm(), at(-0.2, 0, 0))
                       .add(six_joint_arm(), at(0.2, 0, 0, 0, 0, 2))
                       .build();
                 },
                 0, 0.4, 60, 12},
        Scenario{"six_joint_arms_far",
                 [] {
                   return SceneBuilder(false)
                       .add(six_joint_arm(), at(-0.3, 0, 0))
                       .add(six_joint_arm(), at(0.3, 0, 0, 0, 0, 2))
                       .build();
                 },
                 0, 2, 30, 20},
        Scenario{"arm_and_ball",
                 [] {
                   return SceneBuilder(false)
                       .clearance(0.01)
                       .add(six_joint_arm())
                       .add(ball(0.2))
                       .build();
                 },
                 0.8, 0.5, 100, 20},
        Scenario{"odd_arms",
                 [] {
                   return SceneBuilder(false)
                       .clearance(0.01)
                       .add(odd_arm(), at(-0.2, 0, 0))
                       .add(odd_arm(), at(0.2, 0.1, 0.2, 0.3, 1.2, 2))
                       .build();
                 },
                 3, 0.5, 400, 10}),
    name_of);

// ---- One robot ----

class OneRobot : public testing::TestWithParam<Scenario> {};

double outside(const Scene& scene, RobotId robot, ConfigurationView q) {
  double most = -1e300;
  if (!scene.bounds) return most;
  for (const auto& body : reference::bodies(scene, robot, q)) {
    for (const auto& set : body) {
      for (int axis = 0; axis < (scene.planar ? 2 : 3); ++axis) {
        const Vec3 d = Vec3::Unit(axis);
        most = std::max(most, set->support(d)[axis] - scene.bounds->max[axis]);
        most = std::max(most, scene.bounds->min[axis] - set->support(-d)[axis]);
      }
    }
  }
  return most;
}

bool within_limits(const RobotModel& model, ConfigurationView q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (q[i] < model.dofs[i].lower - 1e-8 || q[i] > model.dofs[i].upper + 1e-8) return false;
  }
  return true;
}

bool touches_limits(const RobotModel& model, ConfigurationView q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (q[i] < model.dofs[i].lower + 1e-8 || q[i] > model.dofs[i].upper - 1e-8) return true;
  }
  return false;
}

TEST_P(OneRobot, IsFreeAsLongAsProvedAndNoLonger) {
  const Scenario& scenario = GetParam();
  const auto scene = scenario.make();
  const CollisionWorld world(scene, kPlanningMargin);
  const RobotId robot{0};
  const RobotModel& model = *scene->robots[0].model;
  Random random(11);
  int free = 0;
  int faults = 0;
  for (int k = 0; k < scenario.motions; ++k) {
    const auto a = random_configuration(model, random, scenario.span);
    const auto b = moved(a, random, scenario.step);
    const auto fault = world.first_fault(robot, a, b);
    const double until = fault.value_or(1.0);
    const bool is_free = world.motion_is_free(robot, a, b);
    ASSERT_EQ(is_free, world.motion_is_free(robot, b, a)) << "motion " << k;
    ASSERT_EQ(is_free, !fault) << "motion " << k;
    ASSERT_EQ(world.is_free(robot, a), until > 0) << "motion " << k;
    ASSERT_EQ(world.fault(robot, a).has_value(), !world.is_free(robot, a)) << "motion " << k;
    const auto badness = [&](double u) {  // > 0: not free, by textbook
      const auto q = reference::between(a, b, u);
      if (!within_limits(model, q)) return 1.0;
      return std::max({scene->clearance - reference::obstacle_distance(*scene, robot, q).upper,
                       -reference::self_distance(*scene, robot, q).upper,
                       outside(*scene, robot, q) - 2e-9});
    };
    for (int i = 0; i < scenario.samples && until > 0; ++i) {
      const double u = until * i / scenario.samples;
      ASSERT_LT(badness(u), 0) << "motion " << k << " at " << u;
    }
    if (!fault) {
      ++free;
      ASSERT_LT(badness(1), 0);
    } else if (until > 0) {
      ++faults;
      const auto q = reference::between(a, b, until);
      const bool at_limit = touches_limits(model, q);
      const double gap =
          std::min({reference::obstacle_distance(*scene, robot, q).lower - scene->clearance,
                    reference::self_distance(*scene, robot, q).lower, -outside(*scene, robot, q)});
      ASSERT_TRUE(at_limit || gap < kTight) << "motion " << k << " at " << until << ": " << gap;
    }
  }
  EXPECT_GT(free, scenario.motions / 20);
  EXPECT_GT(faults, scenario.motions / 50);
}

SceneBuilder planar_room() {
  return SceneBuilder(true)
      .clearance(0.05)
      .bounds({-3, -3, 0}, {3, 3, 0})
      .obstacle(Box{Vec3(1, 0.02, 1)}, at(0, 1, 0, 0, 0, 0.3))
      .obstacle(Sphere{0.4}, at(-1.5, 1, 0))
      .obstacle(Cylinder{0.3, 2}, at(1.5, -1, 0))
      .obstacle(Capsule{0.2, 1}, at(-1, -1.5, 0, kHalfPi, 0, 0.5))
      .obstacle(Polygon{ell()}, at(1.8, 1.8, 0, 0, 0, 0.7));
}

SceneBuilder spatial_room() {
  return SceneBuilder(false)
      .clearance(0.02)
      .bounds({-1.5, -1.5, -1}, {1.5, 1.5, 1.2})
      .obstacle(Box{Vec3(0.4, 0.01, 0.6)}, at(0.6, 0.4, 0.4, 0.1, 0.2, 0.3))
      .obstacle(Cylinder{0.15, 0.8}, at(-0.6, 0.2, 0.4, 0, 0, 0))
      .obstacle(Sphere{0.2}, at(0, -0.8, 0.5))
      .obstacle(Capsule{0.1, 0.5}, at(0.5, -0.6, 0.3, kHalfPi, 0.3, 0));
}

INSTANTIATE_TEST_SUITE_P(
    Planar, OneRobot,
    testing::Values(
        Scenario{"disc", [] { return planar_room().add(disk(0.25)).build(); }, 2.7, 2, 400, 30},
        Scenario{"rectangle",
                 [] { return planar_room().add(footprint(rectangle(0.8, 0.3))).build(); }, 2.7, 1,
                 300, 30},
        Scenario{"ell", [] { return planar_room().add(footprint(ell())).build(); }, 2.7, 1, 300,
                 30},
        Scenario{"arm", [] { return planar_room().add(planar_arm()).build(); }, 0, 0.4, 300, 20}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Spatial, OneRobot,
    testing::Values(
        Scenario{"ball", [] { return spatial_room().add(ball(0.15)).build(); }, 1.3, 1, 400, 30},
        Scenario{"six_joint_arm", [] { return spatial_room().add(six_joint_arm()).build(); }, 0,
                 0.4, 100, 10},
        Scenario{"odd_arm", [] { return spatial_room().add(odd_arm(), at(0, 0, 0.2)).build(); }, 3,
                 0.4, 60, 10},
        Scenario{"ball_and_mesh",
                 [] {
                   return SceneBuilder(false)
                       .obstacle(Mesh{ring_mesh(0.5, 0.8, 0.2, 16)}, at(0, 0, 0, 0.3, 0.2, 0))
                       .add(ball(0.15))
                       .build();
                 },
                 1, 1, 100, 10},
        Scenario{"arm_and_mesh",
                 [] {
                   return SceneBuilder(false)
                       .clearance(0.01)
                       .obstacle(Mesh{ring_mesh(0.3, 0.35, 0.05, 8)}, at(0, 0, 0.6, 0.3, 0.2, 0))
                       .add(six_joint_arm())
                       .build();
                 },
                 0, 0.3, 40, 6}),
    name_of);

}  // namespace
}  // namespace accord
