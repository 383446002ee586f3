// Compiles a robot's model into a chain.
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>

#include "common/geometry/chain.h"
#include "common/geometry/piece_reach.h"
#include "common/geometry/planar_cut.h"

namespace accord {
namespace {

[[noreturn]] void reject(const Robot& robot, const std::string& what) {
  throw std::invalid_argument("robot \"" + robot.name + "\": " + what);
}

std::uint64_t next_chain_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

// What a joint needs of the world at q = 0: its anchor and its axis.
struct ZeroJoint {
  Vec3 anchor;
  Vec3 axis;
};

// The frame of a link at q = 0: aligned with the world where planar.
template <int D>
Frame<D> zero_frame(const ZeroJoint& joint);

template <>
Frame<2> zero_frame(const ZeroJoint& joint) {
  return {1, 0, joint.anchor.head<2>()};
}

template <>
Frame<3> zero_frame(const ZeroJoint& joint) {
  Frame<3> frame;
  const Vec3 z = joint.axis.normalized();
  const Vec3 x = z.unitOrthogonal();
  frame.r << x, z.cross(x), z;
  frame.t = joint.anchor;
  return frame;
}

Pose pose_of(const Frame<2>& frame) {
  Pose pose = Pose::Identity();
  pose.translation().head<2>() = frame.t;
  return pose;  // zero frames are aligned with the world
}

Pose pose_of(const Frame<3>& frame) {
  Pose pose = Pose::Identity();
  pose.linear() = frame.r;
  pose.translation() = frame.t;
  return pose;
}

Frame<2> relative(const Frame<2>& base, const Frame<2>& frame) {
  return {1, 0, frame.t - base.t};
}

Frame<3> relative(const Frame<3>& base, const Frame<3>& frame) {
  return {base.r.transpose() * frame.r, base.inverse(frame.t)};
}

// How a revolute axis (z of `origin`) lies to its parent's (z): what ChainLink says.
void compare_axes(ChainLink<2>& link) {
  link.parallel = 1;
}

void compare_axes(ChainLink<3>& link) {
  constexpr double kParallel = 1e-6;  // rad
  const Vec3 axis = link.origin.axis();
  const double side = axis.z() >= 0 ? 1 : -1;
  const double skew = (axis - side * Vec3::UnitZ()).norm();
  if (skew > kParallel) return;
  link.parallel = side;
  link.skew = skew + 1e-15;
}

// Fills what depends on the joint's kind. `base` and `frame`: zero frames of parent and link.
void set_motion(const Robot& robot, const Joint& joint, const Vec3& axis, ChainLink<2>& link) {
  const bool upright = axis.head<2>().norm() <= kPlanarTilt;
  if (joint.type == JointType::kRevolute) {
    if (!upright) reject(robot, "the axis of joint \"" + joint.name + "\" is not parallel to z");
    link.sign = axis.z() > 0 ? 1 : -1;
    compare_axes(link);
    return;
  }
  if (std::abs(axis.z()) > kPlanarTilt) {
    reject(robot, "joint \"" + joint.name + "\" slides out of the plane z = 0");
  }
  link.slide = axis.head<2>().normalized();
}

void set_motion(const Robot&, const Joint& joint, const Vec3& axis, const Frame<3>& base,
                ChainLink<3>& link) {
  if (joint.type == JointType::kRevolute) {
    compare_axes(link);
  } else {
    link.slide = base.unrotate(axis.normalized());
  }
}

void set_motion(const Robot& robot, const Joint& joint, const Vec3& axis, const Frame<2>&,
                ChainLink<2>& link) {
  set_motion(robot, joint, axis, link);
}

}  // namespace

template <int D>
Chain<D>::Chain(const Robot& robot, MeshCache& meshes)
    : id_(next_chain_id()), kind_(robot.model->kind) {
  const bool planar_kind = kind_ == RobotKind::kDisk || kind_ == RobotKind::kFootprint;
  if (mobile() && planar_kind != (D == 2)) {
    reject(robot, D == 2 ? "a ball needs a spatial scene" : "its model needs a planar scene");
  }
  if (mobile()) {
    build_mobile(robot, meshes);
  } else {
    build_arm(robot, meshes);
  }
  find_reach(*robot.model);
}

template <int D>
void Chain<D>::add_body(const Robot& robot, int body, int link, const Pose& pose,
                        MeshCache& meshes) {
  const Body& part = robot.model->bodies[static_cast<std::size_t>(body)];
  try {
    for (Piece<D>& piece : compile_shape<D>(part.shape, pose, meshes)) {
      const PieceReach reach = reach_of(piece);
      pieces_.push_back({std::move(piece), link, body, reach.from_origin, reach.from_axis});
    }
  } catch (const std::invalid_argument& error) {
    reject(robot, "body \"" + part.name + "\" " + error.what());
  }
}

template <int D>
void Chain<D>::build_mobile(const Robot& robot, MeshCache& meshes) {
  if (!robot.base.matrix().isIdentity(0)) {
    reject(robot, "mobile robots stand where q says, so `at` and `rpy` mean nothing to them");
  }
  links_.resize(1);
  for (std::size_t i = 0; i < robot.model->bodies.size(); ++i) {
    add_body(robot, static_cast<int>(i), 0, robot.model->bodies[i].pose, meshes);
  }
  if (kind_ == RobotKind::kFootprint) return;
  if (pieces_.size() != 1 || pieces_[0].piece.core != Core::kPoint || pieces_[0].reach != 0) {
    reject(robot, "must have one round body about its centre");
  }
  radius_ = pieces_[0].piece.radius;
}

template <int D>
void Chain<D>::build_arm(const Robot& robot, MeshCache& meshes) {
  const RobotModel& model = *robot.model;
  const std::size_t count = std::max<std::size_t>(model.links.size(), 1);
  std::vector<Pose> zero(count, robot.base);  // world poses of the model's links at q = 0
  std::vector<int> link_of(count, 0);         // the chain's link that each is part of
  std::vector<Frame<D>> frames(1);            // world frames of the chain's links at q = 0
  links_.resize(1);
  for (const Joint& joint : model.joints) {
    const auto parent = static_cast<std::size_t>(joint.parent);
    const auto child = static_cast<std::size_t>(joint.child);
    zero[child] = zero[parent] * joint.origin;
    link_of[child] = link_of[parent];
    if (joint.type == JointType::kFixed) continue;
    ChainLink<D> link;
    link.parent = link_of[parent];
    link.joint = joint.type;
    link.dof = joint.dof;
    const Frame<D>& base = frames[static_cast<std::size_t>(link.parent)];
    const Vec3 axis = zero[child].linear() * joint.axis;
    Frame<D> frame = base;
    if (joint.type == JointType::kRevolute) {
      frame = zero_frame<D>({zero[child].translation(), axis});
    } else {
      frame.t = zero[child].translation().template head<D>();
    }
    link.origin = relative(base, frame);
    set_motion(robot, joint, axis, base, link);
    link_of[child] = static_cast<int>(links_.size());
    links_.push_back(link);
    frames.push_back(frame);
  }
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const auto model_link = static_cast<std::size_t>(model.bodies[i].link);
    const int link = link_of[model_link];
    const Pose base = pose_of(frames[static_cast<std::size_t>(link)]);
    const Pose pose = base.inverse() * zero[model_link] * model.bodies[i].pose;
    add_body(robot, static_cast<int>(i), link, pose, meshes);
  }
  find_self_pairs(model);
}

template class Chain<2>;
template class Chain<3>;

}  // namespace accord
