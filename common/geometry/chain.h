// A robot compiled for queries: its kinematics as a tree of moving links, its bodies as convex
// pieces, and bounds on how its points move. Mobile robots are chains of one link that q places.
//
// Link frames are chosen for speed, not taken from the model: where all joints are at 0, planar
// frames are aligned with the world and spatial ones have their joint's axis as z. Fixed joints
// are merged away. Immutable; const members may be called concurrently.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/compile_shape.h"
#include "common/geometry/extent.h"
#include "common/geometry/piece.h"
#include "common/model/robot.h"

namespace accord {

template <int D>
struct ChainLink {
  int parent = -1;                      // -1: the root
  JointType joint = JointType::kFixed;  // kFixed: the root of an arm
  int dof = -1;
  double sign = 1;                // planar: -1 where the joint's axis points down
  Frame<D> origin;                // in the parent's frame, at q = 0
  Vec<D> slide = Vec<D>::Zero();  // prismatic: direction in the parent's frame, unit

  // For bounds on motion.
  double parallel = 0;  // +-1: a revolute axis parallel to the parent's turning axis; 0: not
  double skew = 0;      // the angle by which it is not quite
};

// A bound on how a link moves while q goes linearly from one configuration to another, per unit of
// the way: |velocity of its origin| <= speed; angular velocity = a part of norm <= base_turn plus
// `turn` about the link's own axis; |acceleration of its origin| <= bend; |derivative of the
// angular velocity| <= turn_bend. A root's translation is left out (ChainMotion::drift).
struct Swing {
  double speed = 0;
  double base_turn = 0;
  double turn = 0;
  double bend = 0;
  double turn_bend = 0;
};

// The same for a piece's core: how fast, and how bent, the paths of its points can be.
struct Pace {
  double speed = 0;  // m per unit of the way
  double bend = 0;   // m per unit squared
};

template <int D>
struct ChainPiece {
  Piece<D> piece;
  int link;
  int body;             // in RobotModel::bodies
  double reach;         // m, of the core's points from the link's origin
  double reach_across;  // m, of the core's points from the link's axis
};

// Two pieces of one arm that must not touch, and the last link that carries both.
struct SelfPair {
  int a;
  int b;
  int ancestor;
};

template <int D>
class Chain {
 public:
  // Throws std::invalid_argument, naming the robot and the body, where the model does not fit the
  // dimension.
  Chain(const Robot& robot, MeshCache& meshes);
  Chain(Chain&&) noexcept = default;

  // No other chain's, ever: a name that outlives the chain.
  std::uint64_t id() const { return id_; }
  std::span<const ChainLink<D>> links() const { return links_; }
  std::span<const ChainPiece<D>> pieces() const { return pieces_; }
  std::span<const SelfPair> self_pairs() const { return self_pairs_; }  // by ancestor
  std::span<const double> reach() const { return reach_; }              // CollisionWorld::reach
  bool mobile() const { return kind_ != RobotKind::kArm; }
  bool turns() const { return !mobile() || kind_ == RobotKind::kFootprint; }
  // Discs and balls: the radius; negative for the rest.
  double radius() const { return radius_; }
  // Arms: a box that holds every body in every configuration within the limits of prismatic joints.
  const Extent<D>& reach_box() const { return reach_box_; }

  // World frames of all links.
  void place(const double* q, Frame<D>* frames) const;
  // Velocities of all links as q moves by `delta` per unit, at the configuration that the frames
  // were placed for. World coordinates.
  void twists(const double* delta, const Frame<D>* frames, Twist<D>* twists) const;
  // Bounds for the linear motion, for `root` (at rest by definition) and all links that it carries;
  // other links' are left alone. root == -1: in the world.
  void swings(const double* from, const double* to, int root, Swing* swings) const;
  Pace pace(const ChainPiece<D>& piece, const Swing& swing) const;
  // The root's translation over the motion: zero for arms.
  Vec<D> drift(const double* from, const double* to) const;

 private:
  void build_mobile(const Robot& robot, MeshCache& meshes);
  void build_arm(const Robot& robot, MeshCache& meshes);
  void add_body(const Robot& robot, int body, int link, const Pose& pose, MeshCache& meshes);
  void find_self_pairs(const RobotModel& model);
  void find_reach(const RobotModel& model);

  std::uint64_t id_;
  RobotKind kind_;
  double radius_ = -1;
  std::vector<ChainLink<D>> links_;  // parents before children
  std::vector<ChainPiece<D>> pieces_;
  std::vector<SelfPair> self_pairs_;
  std::vector<double> reach_;
  Extent<D> reach_box_ = Extent<D>::nothing();
};

}  // namespace accord
