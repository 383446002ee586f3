// Small scenes and correct plans that the verifier's tests break in one way at a time.
#pragma once

#include <initializer_list>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/model/plan.h"
#include "common/model/scene.h"

namespace accord {

struct Waypoint {
  double t;
  Configuration q;
};

inline Trajectory path(const std::vector<Waypoint>& waypoints) {
  Trajectory out(waypoints.front().q.size());
  for (const Waypoint& w : waypoints) out.append(w.t, w.q);
  return out;
}

inline std::shared_ptr<const RobotModel> disk_model(double radius) {
  auto model = std::make_shared<RobotModel>();
  model->name = "agv";
  model->kind = RobotKind::kDisk;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const char* axis : {"x", "y"}) {
    model->dofs.push_back({axis, -infinity, infinity, 1.0, false});
  }
  model->speed = 1.0;
  model->links = {"body"};
  model->bodies.push_back({"body", 0, Sphere{radius}, Pose::Identity()});
  return model;
}

// Three links of 1 m in the plane, each turning at 1 rad/s within [-3, 3].
inline std::shared_ptr<const RobotModel> arm_model() {
  auto model = std::make_shared<RobotModel>();
  model->name = "arm";
  model->kind = RobotKind::kArm;
  model->links = {"base"};
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i + 1);
    model->dofs.push_back({"joint" + number, -3, 3, 1.0, false});
    model->links.push_back("link" + number);
    Pose origin = Pose::Identity();
    if (i > 0) origin.translation().x() = 1;
    model->joints.push_back(
        {"joint" + number, JointType::kRevolute, i, i + 1, origin, Vec3::UnitZ(), i});
    Pose middle = Pose::Identity();
    middle.translation().x() = 0.5;
    model->bodies.push_back({"link" + number, i + 1, Box{Vec3(0.96, 0.1, 0.1)}, middle});
    model->may_touch.insert({i, i + 1});
  }
  return model;
}

inline Robot robot(std::string name, std::shared_ptr<const RobotModel> model, Configuration start,
                   Configuration goal) {
  return {std::move(name), std::move(model), Pose::Identity(), std::move(start), std::move(goal)};
}

inline Obstacle box_at(std::string name, double x, double y, double width, double height) {
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(x, y, 0);
  return {std::move(name), Box{Vec3(width, height, 1)}, pose};
}

// Two discs of radius 0.2 m that drive at most 1 m/s, clearance 0.1 m, in a hall of 10 m by 10 m
// with a wall of 1 cm across its middle, from y = -5 to y = 3.
inline std::shared_ptr<Scene> hall() {
  auto scene = std::make_shared<Scene>();
  scene->name = "hall";
  scene->clearance = 0.1;
  scene->planar = true;
  scene->bounds = Bounds{Vec3(-5, -5, 0), Vec3(5, 5, 0)};
  scene->obstacles.push_back(box_at("wall", 0, -1, 0.01, 8));
  const auto agv = disk_model(0.2);
  scene->robots.push_back(robot("left", agv, {-4, 4}, {4, 4}));
  scene->robots.push_back(robot("below", agv, {-2, -4}, {-2, 2}));
  return scene;
}

inline Plan plan_of(const Scene& scene, std::vector<Trajectory> paths) {
  Plan plan;
  plan.scene = scene.name;
  plan.status = PlanStatus::kSolved;
  plan.timestep = scene.timestep;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    plan.robots.push_back({scene.robots[i].name, std::move(paths[i]), {}});
  }
  compute_costs(plan);
  return plan;
}

// A correct plan for hall(): left drives along the top, below waits a second and drives up.
inline Plan hall_plan(const Scene& scene) {
  return plan_of(scene, {path({{0, {-4, 4}}, {4, {0, 4}}, {8, {4, 4}}}),
                         path({{0, {-2, -4}}, {1, {-2, -4}}, {7, {-2, 2}}})});
}

// One arm that folds and unfolds above a box, no bounds.
inline std::shared_ptr<Scene> arm_cell() {
  auto scene = std::make_shared<Scene>();
  scene->name = "arm-cell";
  scene->planar = true;
  scene->obstacles.push_back(box_at("table", 1.5, -1.5, 3, 0.2));
  scene->robots.push_back(robot("arm", arm_model(), {0, 0.5, 0.5}, {1.5, -0.5, 0.5}));
  return scene;
}

inline Plan arm_plan(const Scene& scene) {
  return plan_of(scene, {path({{0, {0, 0.5, 0.5}}, {2, {1.5, -0.5, 0.5}}})});
}

}  // namespace accord
