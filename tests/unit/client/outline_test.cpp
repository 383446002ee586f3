#include "client/render/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "client/render/camera.h"

namespace accord {
namespace {

Extent extent_of(const Outline& outline) {
  Extent extent;
  extent.include(outline);
  return extent;
}

TEST(Outline, OfABoxTurnsWithIt) {
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(3, 4, 0);
  pose.linear() = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()).toRotationMatrix();
  const Outline box = outline(Box{Vec3(2, 1, 5)}, pose, View::kTop, true);
  EXPECT_EQ(box.points.size(), 4U);
  EXPECT_TRUE(extent_of(box).low.isApprox(Vec2(2.5, 3), 1e-12));
  EXPECT_TRUE(extent_of(box).high.isApprox(Vec2(3.5, 5), 1e-12));
}

TEST(Outline, OfABallInAPlanarSceneIsItsCut) {
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(0, 0, 0.3);
  EXPECT_NEAR(outline(Sphere{0.5}, pose, View::kTop, true).radius, 0.4, 1e-12);
  EXPECT_NEAR(outline(Sphere{0.5}, pose, View::kTop, false).radius, 0.5, 1e-12);
  pose.translation().z() = 0.6;
  EXPECT_TRUE(outline(Sphere{0.5}, pose, View::kTop, true).points.empty());
}

TEST(Outline, FromTheSideShowsHeights) {
  const Outline can = outline(Cylinder{0.5, 2}, Pose::Identity(), View::kSide, false);
  EXPECT_NEAR(extent_of(can).size().x(), 1, 1e-2);
  EXPECT_NEAR(extent_of(can).size().y(), 2, 1e-12);
}

TEST(Outline, OfANonConvexPolygonKeepsItsNotch) {
  const Polygon ell{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  EXPECT_EQ(outline(ell, Pose::Identity(), View::kTop, true).points.size(), 6U);
}

// Two links of 1 m, the first on a revolute joint, the second on a slide along the first.
Robot crane() {
  auto model = std::make_shared<RobotModel>();
  model->kind = RobotKind::kArm;
  model->dofs = {{"turn", -3, 3, 1, false}, {"slide", 0, 1, 1, false}};
  model->links = {"base", "boom", "trolley"};
  Pose out = Pose::Identity();
  out.translation().x() = 1;
  Pose middle = Pose::Identity();
  middle.translation().x() = 0.5;
  model->joints = {{"turn", JointType::kRevolute, 0, 1, Pose::Identity(), Vec3::UnitZ(), 0},
                   {"slide", JointType::kPrismatic, 1, 2, out, Vec3::UnitX(), 1}};
  model->bodies = {{"trolley", 2, Box{Vec3(1, 0.1, 0.1)}, middle}};
  Robot robot{"crane", model, Pose::Identity(), {0, 0}, {0, 0}};
  robot.base.translation() = Vec3(10, 0, 0);
  return robot;
}

TEST(LinkPoses, FollowTheJoints) {
  const Configuration q{std::numbers::pi / 2, 0.25};
  const std::vector<Pose> poses = link_poses(crane(), q);
  EXPECT_TRUE(poses[0].translation().isApprox(Vec3(10, 0, 0), 1e-12));
  EXPECT_TRUE(poses[2].translation().isApprox(Vec3(10, 1.25, 0), 1e-12));
  EXPECT_TRUE(traced_point(crane(), q).isApprox(Vec3(10, 2.25, 0), 1e-12));
}

}  // namespace
}  // namespace accord
