#include "tests/contract/reference_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace accord::reference {
namespace {

class Ball : public ConvexSet {
 public:
  Ball(Vec3 center, double radius) : center_(std::move(center)), radius_(radius) {}
  Vec3 project(const Vec3& p) const override {
    const Vec3 d = p - center_;
    return d.norm() <= radius_ ? p : Vec3(center_ + d.normalized() * radius_);
  }
  Vec3 support(const Vec3& d) const override { return center_ + d.normalized() * radius_; }

 private:
  Vec3 center_;
  double radius_;
};

// The points within a radius of a segment.
class Stick : public ConvexSet {
 public:
  Stick(Vec3 a, Vec3 b, double radius) : a_(std::move(a)), b_(std::move(b)), radius_(radius) {}
  Vec3 project(const Vec3& p) const override {
    const Vec3 ab = b_ - a_;
    const double u = std::clamp((p - a_).dot(ab) / std::max(ab.squaredNorm(), 1e-300), 0.0, 1.0);
    return Ball(a_ + u * ab, radius_).project(p);
  }
  Vec3 support(const Vec3& d) const override {
    return (a_.dot(d) > b_.dot(d) ? a_ : b_) + radius_ * d.normalized();
  }

 private:
  Vec3 a_;
  Vec3 b_;
  double radius_;
};

class Brick : public ConvexSet {
 public:
  Brick(const Pose& pose, const Vec3& size) : pose_(pose), half_(size / 2) {}
  Vec3 project(const Vec3& p) const override {
    Vec3 local = pose_.inverse() * p;
    for (int i = 0; i < 3; ++i) local[i] = std::clamp(local[i], -half_[i], half_[i]);
    return pose_ * local;
  }
  Vec3 support(const Vec3& d) const override {
    Vec3 local = pose_.linear().transpose() * d;
    for (int i = 0; i < 3; ++i) local[i] = local[i] > 0 ? half_[i] : -half_[i];
    return pose_ * local;
  }

 private:
  Pose pose_;
  Vec3 half_;
};

class Drum : public ConvexSet {
 public:
  Drum(const Pose& pose, double radius, double length)
      : pose_(pose), radius_(radius), half_(length / 2) {}
  Vec3 project(const Vec3& p) const override {
    Vec3 local = pose_.inverse() * p;
    const double out = std::sqrt(local.x() * local.x() + local.y() * local.y());
    if (out > radius_) local.head<2>() *= radius_ / out;
    local.z() = std::clamp(local.z(), -half_, half_);
    return pose_ * local;
  }
  Vec3 support(const Vec3& d) const override {
    const Vec3 local = pose_.linear().transpose() * d;
    Vec3 point(0, 0, local.z() > 0 ? half_ : -half_);
    const double out = local.head<2>().norm();
    if (out > 0) point.head<2>() = local.head<2>() * (radius_ / out);
    return pose_ * point;
  }

 private:
  Pose pose_;
  double radius_;
  double half_;
};

// The hull of a few points in a plane, in order round it; a triangle, or a convex polygon.
class Patch : public ConvexSet {
 public:
  explicit Patch(std::vector<Vec3> v) : v_(std::move(v)) {
    normal_ = (v_[1] - v_[0]).cross(v_[2] - v_[0]).normalized();
  }
  Vec3 project(const Vec3& p) const override {
    const Vec3 flat = p - normal_ * normal_.dot(p - v_[0]);
    bool inside = true;
    Vec3 best = v_[0];
    for (std::size_t i = 0; i < v_.size(); ++i) {
      const Vec3& a = v_[i];
      const Vec3& b = v_[(i + 1) % v_.size()];
      if (normal_.dot((b - a).cross(flat - a)) < 0) inside = false;
      const Vec3 q = Stick(a, b, 0).project(p);
      if ((q - p).norm() < (best - p).norm()) best = q;
    }
    return inside ? flat : best;
  }
  Vec3 support(const Vec3& d) const override {
    return *std::max_element(v_.begin(), v_.end(),
                             [&](const Vec3& a, const Vec3& b) { return a.dot(d) < b.dot(d); });
  }

 private:
  std::vector<Vec3> v_;
  Vec3 normal_;
};

bool convex(const std::vector<Vec2>& v) {
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec2 a = v[(i + 1) % v.size()] - v[i];
    const Vec2 b = v[(i + 2) % v.size()] - v[(i + 1) % v.size()];
    if (a.x() * b.y() - a.y() * b.x() < 0) return false;
  }
  return true;
}

Sets polygon_sets(const std::vector<Vec3>& corners, bool is_convex) {
  Sets sets;
  if (is_convex) {
    sets.push_back(std::make_unique<Patch>(corners));
    return sets;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sets.push_back(std::make_unique<Stick>(corners[i], corners[(i + 1) % corners.size()], 0));
  }
  return sets;
}

struct Maker {
  const Pose& pose;
  bool planar;

  Sets one(std::unique_ptr<ConvexSet> set) const {
    Sets sets;
    sets.push_back(std::move(set));
    return sets;
  }
  Sets operator()(const Sphere& s) const {
    return one(std::make_unique<Ball>(pose.translation(), s.radius));
  }
  Sets operator()(const Capsule& s) const {
    const Vec3 reach = pose.linear().col(2) * (s.length / 2);
    return one(
        std::make_unique<Stick>(pose.translation() - reach, pose.translation() + reach, s.radius));
  }
  Sets operator()(const Cylinder& s) const {
    if (planar) return one(std::make_unique<Ball>(pose.translation(), s.radius));
    return one(std::make_unique<Drum>(pose, s.radius, s.length));
  }
  Sets operator()(const Box& s) const {
    if (!planar) return one(std::make_unique<Brick>(pose, s.size));
    const double x = s.size.x() / 2;
    const double y = s.size.y() / 2;
    return polygon_sets({pose * Vec3(-x, -y, 0), pose * Vec3(x, -y, 0), pose * Vec3(x, y, 0),
                         pose * Vec3(-x, y, 0)},
                        true);
  }
  Sets operator()(const Polygon& s) const {
    std::vector<Vec3> corners;
    for (const Vec2& v : s.vertices) corners.push_back(pose * Vec3(v.x(), v.y(), 0));
    return polygon_sets(corners, convex(s.vertices));
  }
  Sets operator()(const Mesh& s) const {
    Sets sets;
    const auto& v = s.surface->vertices;
    for (const auto& t : s.surface->triangles) {
      sets.push_back(std::make_unique<Patch>(
          std::vector<Vec3>{pose * v[t[0]], pose * v[t[1]], pose * v[t[2]]}));
    }
    return sets;
  }
};

Bracket nearer(const Bracket& a, const Bracket& b) {
  return {std::min(a.lower, b.lower), std::min(a.upper, b.upper)};
}

}  // namespace

Bracket distance(const ConvexSet& a, const ConvexSet& b, double cutoff) {
  constexpr int kRounds = 3000;
  Bracket best{0, 1e300};
  Vec3 on_b = b.support(Vec3(0.36, 0.48, 0.8));
  Vec3 last = on_b;
  for (int i = 0; i < kRounds; ++i) {
    const Vec3 on_a = a.project(on_b);
    on_b = b.project(on_a);
    const Vec3 between = on_b - on_a;
    best.upper = std::min(best.upper, between.norm());
    if (best.upper < 1e-12) return {0, best.upper};
    const Vec3 n = between.normalized();
    best.lower = std::max(best.lower, n.dot(b.support(-n)) - n.dot(a.support(n)));
    if (best.upper - best.lower < 1e-10 || best.lower > cutoff) break;
    // Every few rounds a bold step along the way that the projections drift, if it helps.
    if (i % 5 == 4) {
      const Vec3 bold = b.project(on_b + 20 * (on_b - last));
      if ((bold - a.project(bold)).norm() < best.upper) on_b = bold;
    }
    last = on_b;
  }
  return best;
}

Bracket distance(const Sets& a, const Sets& b, double cutoff) {
  Bracket best{cutoff, cutoff};
  for (const auto& p : a) {
    for (const auto& q : b) best = nearer(best, distance(*p, *q, best.upper));
  }
  return best;
}

Sets sets_of(const Shape& shape, const Pose& pose, bool planar) {
  return std::visit(Maker{pose, planar}, shape);
}

std::vector<Pose> link_poses(const Robot& robot, ConfigurationView q) {
  const RobotModel& model = *robot.model;
  std::vector<Pose> poses(std::max<std::size_t>(model.links.size(), 1), robot.base);
  switch (model.kind) {
    case RobotKind::kDisk:
      poses[0].translation() = Vec3(q[0], q[1], 0);
      break;
    case RobotKind::kBall:
      poses[0].translation() = Vec3(q[0], q[1], q[2]);
      break;
    case RobotKind::kFootprint:
      poses[0].translation() = Vec3(q[0], q[1], 0);
      poses[0].linear() = Eigen::AngleAxisd(q[2], Vec3::UnitZ()).toRotationMatrix();
      break;
    case RobotKind::kArm:
      for (const Joint& joint : model.joints) {
        Pose motion = Pose::Identity();
        if (joint.type == JointType::kRevolute) {
          motion.linear() = Eigen::AngleAxisd(q[static_cast<std::size_t>(joint.dof)], joint.axis)
                                .toRotationMatrix();
        } else if (joint.type == JointType::kPrismatic) {
          motion.translation() = joint.axis * q[static_cast<std::size_t>(joint.dof)];
        }
        poses[static_cast<std::size_t>(joint.child)] =
            poses[static_cast<std::size_t>(joint.parent)] * joint.origin * motion;
      }
  }
  return poses;
}

std::vector<Sets> bodies(const Scene& scene, RobotId robot, ConfigurationView q) {
  const std::vector<Pose> poses = link_poses(scene.robot(robot), q);
  std::vector<Sets> result;
  for (const Body& body : scene.robot(robot).model->bodies) {
    result.push_back(
        sets_of(body.shape, poses[static_cast<std::size_t>(body.link)] * body.pose, scene.planar));
  }
  return result;
}

Sets obstacles(const Scene& scene) {
  Sets all;
  for (const Obstacle& obstacle : scene.obstacles) {
    for (auto& set : sets_of(obstacle.shape, obstacle.pose, scene.planar)) {
      all.push_back(std::move(set));
    }
  }
  return all;
}

Bracket robot_distance(const Scene& scene, RobotId a, ConfigurationView qa, RobotId b,
                       ConfigurationView qb) {
  Bracket best{1e300, 1e300};
  const auto other = bodies(scene, b, qb);
  for (const Sets& p : bodies(scene, a, qa)) {
    for (const Sets& q : other) best = nearer(best, distance(p, q, best.upper));
  }
  return best;
}

Bracket obstacle_distance(const Scene& scene, RobotId robot, ConfigurationView q) {
  Bracket best{1e300, 1e300};
  const Sets all = obstacles(scene);
  for (const Sets& p : bodies(scene, robot, q)) best = nearer(best, distance(p, all, best.upper));
  return best;
}

Bracket self_distance(const Scene& scene, RobotId robot, ConfigurationView q) {
  Bracket best{1e300, 1e300};
  const auto parts = bodies(scene, robot, q);
  const RobotModel& model = *scene.robot(robot).model;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      const int a = model.bodies[i].link;
      const int b = model.bodies[j].link;
      if (a == b || model.may_touch.contains({std::min(a, b), std::max(a, b)})) continue;
      best = nearer(best, distance(parts[i], parts[j], best.upper));
    }
  }
  return best;
}

Configuration between(ConfigurationView a, ConfigurationView b, double u) {
  Configuration q(a.begin(), a.end());
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += u * (b[i] - a[i]);
  return q;
}

}  // namespace accord::reference
