// Small scenes for tests, built in a line or two.
#pragma once

#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "common/model/scene.h"
#include "common/model/trajectory.h"

namespace accord::testing {

inline std::shared_ptr<const RobotModel> disk_model(double radius, double speed = 1) {
  auto model = std::make_shared<RobotModel>();
  model->name = "disk";
  model->kind = RobotKind::kDisk;
  const double infinity = std::numeric_limits<double>::infinity();
  model->dofs = {{"x", -infinity, infinity, speed, false},
                 {"y", -infinity, infinity, speed, false}};
  model->speed = speed;
  model->links = {"base"};
  model->bodies = {{"base", 0, Sphere{radius}, Pose::Identity()}};
  return model;
}

inline std::shared_ptr<const RobotModel> cart_model(double length, double width, double speed = 1,
                                                    double turn = 1) {
  auto model = std::make_shared<RobotModel>();
  model->name = "cart";
  model->kind = RobotKind::kFootprint;
  const double infinity = std::numeric_limits<double>::infinity();
  model->dofs = {{"x", -infinity, infinity, speed, false},
                 {"y", -infinity, infinity, speed, false},
                 {"heading", -infinity, infinity, turn, true}};
  model->speed = speed;
  model->links = {"base"};
  const double x = length / 2, y = width / 2;
  model->bodies = {
      {"base", 0, Polygon{{Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)}}, Pose::Identity()}};
  return model;
}

// A planar arm of revolute joints about z; each link a bar from its joint along x.
inline std::shared_ptr<const RobotModel> planar_arm_model(const std::vector<double>& lengths,
                                                          double width = 0.1) {
  auto model = std::make_shared<RobotModel>();
  model->name = "arm";
  model->kind = RobotKind::kArm;
  model->links = {"base"};
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const int link = static_cast<int>(i) + 1;
    model->links.push_back("link" + std::to_string(link));
    model->dofs.push_back({"joint" + std::to_string(link), -3.1, 3.1, 1.0, false});
    Pose origin = Pose::Identity();
    if (i > 0) origin.translation().x() = lengths[i - 1];
    model->joints.push_back({"joint" + std::to_string(link), JointType::kRevolute, link - 1, link,
                             origin, Vec3::UnitZ(), static_cast<int>(i)});
    Pose middle = Pose::Identity();
    middle.translation().x() = lengths[i] / 2;
    model->bodies.push_back(
        {model->links.back(), link, Box{Vec3(lengths[i], width, width)}, middle});
    model->may_touch.insert({link - 1, link});
  }
  return model;
}

class SceneBuilder {
 public:
  // A planar scene with the given bounds.
  SceneBuilder(double x0, double y0, double x1, double y1) {
    scene_.name = "test";
    scene_.planar = true;
    scene_.bounds = Bounds{Vec3(x0, y0, 0), Vec3(x1, y1, 0)};
  }

  SceneBuilder& clearance(double metres) {
    scene_.clearance = metres;
    return *this;
  }
  SceneBuilder& box(double x0, double y0, double x1, double y1) {
    Pose pose = Pose::Identity();
    pose.translation() = Vec3((x0 + x1) / 2, (y0 + y1) / 2, 0);
    scene_.obstacles.push_back(
        {"box " + std::to_string(scene_.obstacles.size()), Box{Vec3(x1 - x0, y1 - y0, 1)}, pose});
    return *this;
  }
  SceneBuilder& robot(std::shared_ptr<const RobotModel> model, Configuration start,
                      Configuration goal, Pose base = Pose::Identity()) {
    scene_.robots.push_back({"r" + std::to_string(scene_.robots.size()), std::move(model), base,
                             std::move(start), std::move(goal)});
    return *this;
  }
  SceneBuilder& disk(double radius, Configuration start, Configuration goal) {
    return robot(disk_model(radius), std::move(start), std::move(goal));
  }

  std::shared_ptr<const Scene> build() const { return std::make_shared<Scene>(scene_); }

 private:
  Scene scene_;
};

// A path through timed waypoints: {{t, q}, ...}.
inline Trajectory path(const std::vector<std::pair<double, Configuration>>& waypoints) {
  Trajectory out(waypoints.front().second.size());
  for (const auto& [t, q] : waypoints) out.append(t, q);
  return out;
}

}  // namespace accord::testing
