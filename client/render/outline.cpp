#include "client/render/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace accord {
namespace {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// Andrew's monotone chain (1979).
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::ranges::sort(points, [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  const auto turns_right = [](const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() <= 0;
  };
  std::vector<Vec2> hull;
  const auto chain = [&](auto begin, auto end, std::size_t floor) {
    for (; begin != end; ++begin) {
      while (hull.size() >= floor + 2 && turns_right(hull[hull.size() - 2], hull.back(), *begin)) {
        hull.pop_back();
      }
      hull.push_back(*begin);
    }
    hull.pop_back();
  };
  if (points.size() < 3) return points;
  chain(points.begin(), points.end(), 0);
  chain(points.rbegin(), points.rend(), hull.size());
  return hull;
}

Outline shadow(const std::vector<Vec3>& points, const Pose& pose, View view) {
  std::vector<Vec2> flat;
  flat.reserve(points.size());
  for (const Vec3& point : points) flat.push_back(projected(view, pose * point));
  return {convex_hull(std::move(flat)), 0};
}

std::vector<Vec3> box_corners(const Vec3& size) {
  std::vector<Vec3> corners;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) corners.push_back(Vec3(x, y, z).cwiseProduct(size));
    }
  }
  return corners;
}

constexpr int kRoundCorners = 24;

std::vector<Vec3> cylinder_rims(const Cylinder& cylinder) {
  std::vector<Vec3> rims;
  for (int i = 0; i < kRoundCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRoundCorners;
    const double x = cylinder.radius * std::cos(angle);
    const double y = cylinder.radius * std::sin(angle);
    rims.emplace_back(x, y, -cylinder.length / 2);
    rims.emplace_back(x, y, cylinder.length / 2);
  }
  return rims;
}

// Circles about both ends, drawn in the view's plane.
Outline capsule_shadow(const Capsule& capsule, const Pose& pose, View view) {
  std::vector<Vec2> points;
  for (const double end : {-0.5, 0.5}) {
    const Vec2 centre = projected(view, pose * Vec3(0, 0, end * capsule.length));
    for (int i = 0; i < kRoundCorners; ++i) {
      const double angle = 2 * std::numbers::pi * i / kRoundCorners;
      points.push_back(centre + capsule.radius * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  return {convex_hull(std::move(points)), 0};
}

Outline sphere_outline(double radius, const Pose& pose, View view, bool planar) {
  const Vec3 centre = pose.translation();
  if (planar) {
    const double squared = radius * radius - centre.z() * centre.z();
    if (squared <= 0) return {};
    radius = std::sqrt(squared);
  }
  return {{projected(view, centre)}, radius};
}

Pose joint_motion(const Joint& joint, ConfigurationView q) {
  Pose motion = Pose::Identity();
  if (joint.type == JointType::kFixed) return motion;
  const double value = q[static_cast<std::size_t>(joint.dof)];
  if (joint.type == JointType::kRevolute) {
    motion.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
  } else {
    motion.translation() = value * joint.axis;
  }
  return motion;
}

Pose mobile_pose(const Robot& robot, ConfigurationView q) {
  Pose pose = Pose::Identity();
  for (std::size_t i = 0; i < robot.model->translations(); ++i) {
    pose.translation()[static_cast<Eigen::Index>(i)] = q[i];
  }
  if (robot.model->kind == RobotKind::kFootprint) {
    pose.linear() = Eigen::AngleAxisd(q[2], Vec3::UnitZ()).toRotationMatrix();
  }
  return robot.base * pose;
}

// Opposite the joint, seen from the middle of the body.
Vec3 far_end(const Body& body) {
  return 2 * body.pose.translation();
}

}  // namespace

Vec2 projected(View view, const Vec3& point) {
  return view == View::kTop ? Vec2(point.x(), point.y()) : Vec2(point.x(), point.z());
}

Outline outline(const Shape& shape, const Pose& pose, View view, bool planar) {
  return std::visit(
      Overloaded{
          [&](const Sphere& s) { return sphere_outline(s.radius, pose, view, planar); },
          [&](const Capsule& c) { return capsule_shadow(c, pose, view); },
          [&](const Cylinder& c) { return shadow(cylinder_rims(c), pose, view); },
          [&](const Box& b) { return shadow(box_corners(b.size), pose, view); },
          [&](const Polygon& p) {
            Outline out;
            for (const Vec2& v : p.vertices) {
              out.points.push_back(projected(view, pose * Vec3(v.x(), v.y(), 0)));
            }
            return out;
          },
          [&](const Mesh& m) { return shadow(m.surface->vertices, pose, view); },
      },
      shape);
}

std::vector<Pose> link_poses(const Robot& robot, ConfigurationView q) {
  if (robot.model->kind != RobotKind::kArm) return {mobile_pose(robot, q)};
  std::vector<Pose> poses(robot.model->links.size(), robot.base);
  for (const Joint& joint : robot.model->joints) {
    poses[static_cast<std::size_t>(joint.child)] =
        poses[static_cast<std::size_t>(joint.parent)] * joint.origin * joint_motion(joint, q);
  }
  return poses;
}

std::vector<Outline> robot_outlines(const Robot& robot, ConfigurationView q, View view,
                                    bool planar) {
  const std::vector<Pose> links = link_poses(robot, q);
  std::vector<Outline> out;
  for (const Body& body : robot.model->bodies) {
    const Pose pose = links[static_cast<std::size_t>(body.link)] * body.pose;
    out.push_back(outline(body.shape, pose, view, planar));
  }
  return out;
}

Vec3 standing_point(const Robot& robot, ConfigurationView q) {
  return link_poses(robot, q).front().translation();
}

Vec3 traced_point(const Robot& robot, ConfigurationView q) {
  const std::vector<Pose> links = link_poses(robot, q);
  if (robot.model->kind != RobotKind::kArm) return links.front().translation();
  const RobotModel& model = *robot.model;
  for (auto joint = model.joints.rbegin(); joint != model.joints.rend(); ++joint) {
    const auto body = std::ranges::find(model.bodies, joint->child, &Body::link);
    if (body == model.bodies.end()) continue;
    return links[static_cast<std::size_t>(joint->child)] * far_end(*body);
  }
  return links.back().translation();
}

}  // namespace accord
