// The verifier against brute force: random plans, looked at at thousands of instants.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/geometry/collision_world.h"
#include "common/planning/verifier.h"
#include "tests/unit/planning/verifier_scenes.h"

namespace accord {
namespace {

constexpr double kHorizon = 10;  // s
constexpr int kInstants = 4000;
constexpr double kFast = 1e3;  // no motion breaks a speed limit
// What sampling may miss between two instants and what a contact's resolution may add.
constexpr double kSlack = 1e-6;  // m

std::shared_ptr<const RobotModel> ell_model() {
  auto model = std::make_shared<RobotModel>();
  model->name = "ell";
  model->kind = RobotKind::kFootprint;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const char* name : {"x", "y"})
    model->dofs.push_back({name, -infinity, infinity, kFast, false});
  model->dofs.push_back({"heading", -infinity, infinity, kFast, true});
  model->speed = kFast;
  model->links = {"body"};
  model->bodies.push_back(
      {"body", 0, Polygon{{{-1, -1}, {1, -1}, {1, -0.6}, {-0.6, -0.6}, {-0.6, 1}, {-1, 1}}},
       Pose::Identity()});
  return model;
}

std::shared_ptr<const RobotModel> fast(std::shared_ptr<const RobotModel> slow) {
  auto model = std::make_shared<RobotModel>(*slow);
  model->speed = kFast;
  for (DegreeOfFreedom& dof : model->dofs) dof.velocity = kFast;
  return model;
}

// One link of 1.5 m about the origin, free of itself.
std::shared_ptr<const RobotModel> boom_model() {
  auto model = std::make_shared<RobotModel>(*fast(arm_model()));
  model->dofs.resize(1);
  model->joints.resize(1);
  model->links.resize(2);
  model->bodies.resize(1);
  return model;
}

struct RandomCase {
  std::shared_ptr<Scene> scene;
  Plan plan;
};

RandomCase random_case(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  auto scene = std::make_shared<Scene>();
  scene->name = "random";
  scene->planar = true;
  scene->clearance = uniform(0, 1) < 0.5 ? 0 : 0.1;
  std::vector<Trajectory> paths;
  for (const auto& model :
       {fast(disk_model(0.3)), fast(disk_model(0.2)), ell_model(), boom_model()}) {
    Trajectory path(model->dof());
    const int waypoints = std::uniform_int_distribution<int>(1, 6)(random);
    for (int i = 0; i < waypoints; ++i) {
      Configuration q(model->dof());
      for (std::size_t k = 0; k < q.size(); ++k) q[k] = k < 2 ? uniform(-8, 8) : uniform(-9, 9);
      if (model->kind == RobotKind::kArm) q[0] = uniform(-3, 3);
      path.append(i == 0 ? 0 : uniform(i, i + 0.99) * kHorizon / 7, q);
    }
    const auto first = path.configuration(0);
    const auto last = path.configuration(path.size() - 1);
    scene->robots.push_back(robot(std::to_string(scene->robots.size()), model,
                                  {first.begin(), first.end()}, {last.begin(), last.end()}));
    paths.push_back(std::move(path));
  }
  Plan plan = plan_of(*scene, std::move(paths));
  return {std::move(scene), std::move(plan)};
}

struct Sampled {
  double separation = 1;      // m, the smallest met, at most 1
  double first_contact = -1;  // s, the first instant at which clearance is clearly broken
};

Sampled sample(const RandomCase& c, const CollisionWorld& world) {
  Sampled out;
  for (int i = 0; i <= kInstants; ++i) {
    const double t = kHorizon * i / kInstants;
    for (std::uint32_t a = 0; a < c.scene->robots.size(); ++a) {
      for (std::uint32_t b = a + 1; b < c.scene->robots.size(); ++b) {
        const double gap = world.separation({a}, c.plan.robots[a].trajectory.at(t), {b},
                                            c.plan.robots[b].trajectory.at(t), 1.0);
        out.separation = std::min(out.separation, gap);
        const bool contact = gap < c.scene->clearance - kSlack || gap <= 0;
        if (contact && out.first_contact < 0) out.first_contact = t;
      }
    }
  }
  return out;
}

TEST(VerifierAgainstBruteForce, MissesNothingAndInventsNothing) {
  std::mt19937_64 random(7);
  int proved = 0;
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE(i);
    const RandomCase c = random_case(random);
    const CollisionWorld world(c.scene, 0);
    const Sampled sampled = sample(c, world);
    const Verdict verdict = verify(c.scene, c.plan, 1 + static_cast<unsigned>(i) % 2);
    if (verdict.proved()) {
      ++proved;
      EXPECT_LT(sampled.first_contact, 0);
      const double reported = verdict.robots ? verdict.robots->distance : 1.0;
      EXPECT_LE(reported, sampled.separation + kSlack);
      EXPECT_GT(reported, sampled.separation - 0.05);
    } else {
      ASSERT_EQ(verdict.violation->kind, Violation::Kind::kRobots) << verdict.violation->text;
      EXPECT_LE(verdict.violation->gap, c.scene->clearance + kSlack) << verdict.violation->text;
      if (sampled.first_contact >= 0) {
        EXPECT_LE(verdict.violation->time, sampled.first_contact);
      }
    }
  }
  EXPECT_GT(proved, 20);
  EXPECT_LT(proved, 100);
}

}  // namespace
}  // namespace accord
