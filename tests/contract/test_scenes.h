// Robots and obstacles for tests, made in code.
#pragma once

#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "common/model/scene.h"

namespace accord::test_scenes {

Pose at(double x, double y, double z = 0, double roll = 0, double pitch = 0, double yaw = 0);

std::shared_ptr<const RobotModel> disk(double radius);
std::shared_ptr<const RobotModel> ball(double radius);
std::shared_ptr<const RobotModel> footprint(std::vector<Vec2> corners);
std::vector<Vec2> rectangle(double length, double width);
std::vector<Vec2> ell();  // not convex

// scenes/planar3.urdf and scenes/arm6.urdf.
std::shared_ptr<const RobotModel> planar_arm();
std::shared_ptr<const RobotModel> six_joint_arm();
// A spatial arm with a prismatic joint, a flipped axis, a fixed joint, a branch, and one body of
// each kind of shape, a mesh among them.
std::shared_ptr<const RobotModel> odd_arm();

// A closed box of twelve triangles.
std::shared_ptr<const TriangleMesh> box_mesh(const Vec3& size);
// A closed surface that is not convex: a ring of square cross-section.
std::shared_ptr<const TriangleMesh> ring_mesh(double inner, double outer, double height,
                                              unsigned sides);

Robot robot(std::string name, std::shared_ptr<const RobotModel> model,
            const Pose& base = Pose::Identity());

// Builds a scene piece by piece.
class SceneBuilder {
 public:
  explicit SceneBuilder(bool planar) { scene_.planar = planar; }
  SceneBuilder& clearance(double c) {
    scene_.clearance = c;
    return *this;
  }
  SceneBuilder& bounds(const Vec3& min, const Vec3& max) {
    scene_.bounds = Bounds{min, max};
    return *this;
  }
  SceneBuilder& obstacle(Shape shape, const Pose& pose) {
    scene_.obstacles.push_back(
        {"obstacle " + std::to_string(scene_.obstacles.size()), std::move(shape), pose});
    return *this;
  }
  SceneBuilder& add(std::shared_ptr<const RobotModel> model, const Pose& base = Pose::Identity()) {
    scene_.robots.push_back(
        robot("r" + std::to_string(scene_.robots.size()), std::move(model), base));
    return *this;
  }
  std::shared_ptr<const Scene> build() const { return std::make_shared<const Scene>(scene_); }

 private:
  Scene scene_;
};

using Random = std::mt19937_64;
double uniform(Random& random, double low, double high);
// Within the limits, or [-span, span] where there are none.
Configuration random_configuration(const RobotModel& model, Random& random, double span);
Pose random_pose(Random& random, double span);

}  // namespace accord::test_scenes
