#include "tests/contract/test_scenes.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace accord::test_scenes {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

DegreeOfFreedom free_dof(std::string name, bool wraps = false) {
  return {std::move(name), -kInfinity, kInfinity, 1, wraps};
}

Joint revolute(int parent, int child, const Pose& origin, const Vec3& axis, int dof) {
  return {"joint" + std::to_string(child), JointType::kRevolute, parent, child, origin, axis, dof};
}

std::shared_ptr<RobotModel> empty_arm(std::size_t links) {
  auto model = std::make_shared<RobotModel>();
  model->name = "arm";
  model->kind = RobotKind::kArm;
  for (std::size_t i = 0; i < links; ++i) model->links.push_back("link" + std::to_string(i));
  return model;
}

void body(RobotModel& model, int link, Shape shape, const Pose& pose) {
  model.bodies.push_back(
      {model.links[static_cast<std::size_t>(link)], link, std::move(shape), pose});
}

}  // namespace

Pose at(double x, double y, double z, double roll, double pitch, double yaw) {
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(x, y, z);
  pose.linear() = (Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::AngleAxisd(pitch, Vec3::UnitY()) *
                   Eigen::AngleAxisd(roll, Vec3::UnitX()))
                      .toRotationMatrix();
  return pose;
}

std::shared_ptr<const RobotModel> disk(double radius) {
  auto model = std::make_shared<RobotModel>();
  model->kind = RobotKind::kDisk;
  model->dofs = {free_dof("x"), free_dof("y")};
  model->speed = 1;
  model->links = {"body"};
  body(*model, 0, Sphere{radius}, Pose::Identity());
  return model;
}

std::shared_ptr<const RobotModel> ball(double radius) {
  auto model = std::make_shared<RobotModel>();
  model->kind = RobotKind::kBall;
  model->dofs = {free_dof("x"), free_dof("y"), free_dof("z")};
  model->speed = 1;
  model->links = {"body"};
  body(*model, 0, Sphere{radius}, Pose::Identity());
  return model;
}

std::shared_ptr<const RobotModel> footprint(std::vector<Vec2> corners) {
  auto model = std::make_shared<RobotModel>();
  model->kind = RobotKind::kFootprint;
  model->dofs = {free_dof("x"), free_dof("y"), free_dof("heading", true)};
  model->speed = 1;
  model->links = {"body"};
  body(*model, 0, Polygon{std::move(corners)}, Pose::Identity());
  return model;
}

std::vector<Vec2> rectangle(double length, double width) {
  const double x = length / 2;
  const double y = width / 2;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

std::vector<Vec2> ell() {
  return {{-0.6, -0.6}, {0.6, -0.6}, {0.6, -0.1}, {-0.1, -0.1}, {-0.1, 0.6}, {-0.6, 0.6}};
}

std::shared_ptr<const RobotModel> planar_arm() {
  auto model = empty_arm(4);
  for (int i = 1; i <= 3; ++i) {
    const double limit = i == 1 ? 3.1 : 2.6;
    model->dofs.push_back({"q" + std::to_string(i), -limit, limit, 1, false});
    model->joints.push_back(revolute(i - 1, i, at(i == 1 ? 0 : 1, 0), Vec3::UnitZ(), i - 1));
    body(*model, i, Box{Vec3(1, 0.12, 0.12)}, at(0.5, 0));
    model->may_touch.insert({i - 1, i});
  }
  return model;
}

std::shared_ptr<const RobotModel> six_joint_arm() {
  auto model = empty_arm(7);
  const std::vector<double> heights{0.13, 0.11, 0.40, 0.20, 0.17, 0.10};
  const std::vector<Cylinder> shapes{{0.075, 0.12}, {0.07, 0.1},  {0.055, 0.4}, {0.045, 0.2},
                                     {0.04, 0.16},  {0.035, 0.1}, {0.03, 0.09}};
  const std::vector<double> middles{0.06, 0.05, 0.2, 0.1, 0.08, 0.05, 0.045};
  const std::vector<double> limits{3.1, 2.0, 2.6, 3.1, 2.1, 3.1};
  for (int i = 0; i < 7; ++i) {
    const auto k = static_cast<std::size_t>(i);
    body(*model, i, shapes[k], at(0, 0, middles[k]));
    if (i == 6) break;
    const bool pitch = i == 1 || i == 2 || i == 4;
    model->dofs.push_back({"q" + std::to_string(i), -limits[k], limits[k], 2, false});
    model->joints.push_back(
        revolute(i, i + 1, at(0, 0, heights[k]), pitch ? Vec3::UnitY() : Vec3::UnitZ(), i));
    model->may_touch.insert({i, i + 1});
  }
  return model;
}

std::shared_ptr<const RobotModel> odd_arm() {
  auto model = empty_arm(6);
  model->dofs = {{"turn", -3, 3, 1, false},
                 {"slide", -0.2, 0.5, 1, false},
                 {"tilt", -2, 2, 1, false},
                 {"other", -kInfinity, kInfinity, 1, true}};
  model->joints = {
      revolute(0, 1, at(0, 0, 0.2, std::numbers::pi), Vec3::UnitZ(), 0),
      {"slide", JointType::kPrismatic, 1, 2, at(0.1, 0, -0.2, 0.3, 0.2, 0.1), Vec3(0.6, 0, -0.8),
       1},
      {"flange", JointType::kFixed, 2, 3, at(0, 0, -0.3, 1.570796, 0, 0), Vec3::UnitZ(), -1},
      revolute(3, 4, at(0.1, 0.05, 0.1, 0, 0.4, 0), Vec3(0, 0.6, 0.8), 2),
      revolute(1, 5, at(-0.2, 0, 0), Vec3(0, 1, 0), 3),
  };
  body(*model, 0, Cylinder{0.1, 0.1}, at(0, 0, 0));
  body(*model, 1, Box{Vec3(0.2, 0.1, 0.1)}, at(0, 0, 0));
  body(*model, 2, Capsule{0.04, 0.2}, at(0, 0, -0.1, 0.1, 0.2, 0));
  body(*model, 3, Sphere{0.06}, at(0, 0, 0));
  body(*model, 4, Mesh{box_mesh(Vec3(0.1, 0.15, 0.3))}, at(0, 0, 0.2, 0.3, 0, 0));
  body(*model, 5, Cylinder{0.03, 0.4}, at(-0.2, 0, 0, 0, 1.570796, 0));
  model->may_touch = {{0, 1}, {1, 2}, {2, 3}, {1, 3}, {3, 4}, {2, 4}, {1, 5}};
  return model;
}

std::shared_ptr<const TriangleMesh> box_mesh(const Vec3& size) {
  auto mesh = std::make_shared<TriangleMesh>();
  for (unsigned i = 0; i < 8; ++i) {
    mesh->vertices.emplace_back(((i & 1U) != 0 ? 0.5 : -0.5) * size.x(),
                                ((i & 2U) != 0 ? 0.5 : -0.5) * size.y(),
                                ((i & 4U) != 0 ? 0.5 : -0.5) * size.z());
  }
  mesh->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  mesh->closed = true;
  return mesh;
}

std::shared_ptr<const TriangleMesh> ring_mesh(double inner, double outer, double height,
                                              unsigned sides) {
  auto mesh = std::make_shared<TriangleMesh>();
  for (unsigned i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double r : {inner, outer}) {
      for (const double z : {-height / 2, height / 2}) {
        mesh->vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
      }
    }
  }
  // Per side the vertices are: inner low, inner high, outer low, outer high.
  constexpr std::array<std::array<unsigned, 2>, 4> kWalls{{{0, 1}, {1, 3}, {3, 2}, {2, 0}}};
  for (unsigned i = 0; i < sides; ++i) {
    const unsigned a = 4 * i;
    const unsigned b = 4 * ((i + 1) % sides);
    for (const auto& [p, q] : kWalls) {
      mesh->triangles.push_back({a + p, a + q, b + p});
      mesh->triangles.push_back({b + p, a + q, b + q});
    }
  }
  mesh->closed = true;
  return mesh;
}

Robot robot(std::string name, std::shared_ptr<const RobotModel> model, const Pose& base) {
  Configuration zero(model->dof(), 0.0);
  return {std::move(name), std::move(model), base, zero, zero};
}

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Configuration random_configuration(const RobotModel& model, Random& random, double span) {
  Configuration q;
  for (const DegreeOfFreedom& dof : model.dofs) {
    q.push_back(std::isfinite(dof.lower) ? uniform(random, dof.lower, dof.upper)
                                         : uniform(random, -span, span));
  }
  return q;
}

Pose random_pose(Random& random, double span) {
  const double pi = std::numbers::pi;
  return at(uniform(random, -span, span), uniform(random, -span, span),
            uniform(random, -span, span), uniform(random, -pi, pi), uniform(random, -pi, pi),
            uniform(random, -pi, pi));
}

}  // namespace accord::test_scenes
