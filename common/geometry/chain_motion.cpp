// Where a chain's links are, how they move, and how fast they can.
#include <algorithm>
#include <cmath>

#include "common/geometry/chain.h"

namespace accord {
namespace {

Frame<2> turned(const Frame<2>& base, const ChainLink<2>& link, double q) {
  const SinCos a = sincos(link.sign * q);
  return {base.c * a.cos - base.s * a.sin, base.s * a.cos + base.c * a.sin, base(link.origin.t)};
}

Frame<3> turned(const Frame<3>& base, const ChainLink<3>& link, double q) {
  const SinCos a = sincos(q);
  Frame<3> frame = base * link.origin;  // then about its own z
  const Vec<3> x = frame.r.col(0);
  const Vec<3> y = frame.r.col(1);
  frame.r.col(0) = a.cos * x + a.sin * y;
  frame.r.col(1) = a.cos * y - a.sin * x;
  return frame;
}

double spin(const ChainLink<2>& link, const Frame<2>&, double rate) {
  return link.sign * rate;
}
Vec<3> spin(const ChainLink<3>&, const Frame<3>& frame, double rate) {
  return rate * frame.axis();
}

// Distance from the turning axis of the frame that v is given in.
double across(const Vec<2>& v) {
  return v.norm();
}
double across(const Vec<3>& v) {
  return std::sqrt(v.x() * v.x() + v.y() * v.y());
}

// Bounds are products and sums of a few numbers; this covers their rounding.
constexpr double kRoundUp = 1 + 1e-12;

}  // namespace

template <int D>
void Chain<D>::place(const double* q, Frame<D>* frames) const {
  if (mobile()) {
    for (int i = 0; i < D; ++i) frames[0].t[i] = q[i];
    if constexpr (D == 2) {
      if (kind_ == RobotKind::kFootprint) {
        const SinCos heading = sincos(q[2]);
        frames[0].c = heading.cos;
        frames[0].s = heading.sin;
      } else {
        frames[0].c = 1;
        frames[0].s = 0;
      }
    } else {
      frames[0].r.setIdentity();
    }
    return;
  }
  frames[0] = Frame<D>{};
  for (std::size_t i = 1; i < links_.size(); ++i) {
    const ChainLink<D>& link = links_[i];
    const Frame<D>& base = frames[link.parent];
    if (link.joint == JointType::kRevolute) {
      frames[i] = turned(base, link, q[link.dof]);
    } else {
      frames[i] = base;
      frames[i].t = base(link.origin.t + q[link.dof] * link.slide);
    }
  }
}

template <int D>
Vec<D> Chain<D>::drift(const double* from, const double* to) const {
  Vec<D> drift = Vec<D>::Zero();
  if (mobile()) {
    for (int i = 0; i < D; ++i) drift[i] = to[i] - from[i];
  }
  return drift;
}

template <int D>
void Chain<D>::twists(const double* delta, const Frame<D>* frames, Twist<D>* twists) const {
  twists[0] = Twist<D>{};
  if (mobile()) {
    for (int i = 0; i < D; ++i) twists[0].linear[i] = delta[i];
    if constexpr (D == 2) {
      if (kind_ == RobotKind::kFootprint) twists[0].angular = delta[2];
    }
    return;
  }
  for (std::size_t i = 1; i < links_.size(); ++i) {
    const ChainLink<D>& link = links_[i];
    const Twist<D>& base = twists[link.parent];
    const Frame<D>& base_frame = frames[link.parent];
    const double rate = delta[link.dof];
    twists[i].linear = base.at(frames[i].t - base_frame.t);
    twists[i].angular = base.angular;
    if (link.joint == JointType::kRevolute) {
      twists[i].angular += spin(link, frames[i], rate);
    } else {
      twists[i].linear += rate * base_frame.rotate(link.slide);
    }
  }
}

template <int D>
void Chain<D>::swings(const double* from, const double* to, int root, Swing* swings) const {
  const int first = std::max(root, 0);
  swings[first] = Swing{};
  if (root < 0 && kind_ == RobotKind::kFootprint) swings[0].turn = to[2] - from[2];
  for (int i = first + 1; i < static_cast<int>(links_.size()); ++i) {
    const ChainLink<D>& link = links_[static_cast<std::size_t>(i)];
    if (link.parent < first) continue;  // not carried by the root
    const Swing& base = swings[link.parent];
    Swing& swing = swings[i];
    const double change = (to[link.dof] - from[link.dof]) * link.sign;
    const double turning = base.base_turn + std::abs(base.turn);
    double arm = link.origin.t.norm();
    double arm_across = across(link.origin.t);
    if (link.joint == JointType::kPrismatic) {
      const Vec<D> a = link.origin.t + from[link.dof] * link.slide;
      const Vec<D> b = link.origin.t + to[link.dof] * link.slide;
      arm = std::max(a.norm(), b.norm());
      arm_across = std::max(across(a), across(b));
    }
    const double swept = base.base_turn * arm + std::abs(base.turn) * arm_across;
    swing = base;
    swing.speed += swept;
    swing.bend += base.turn_bend * arm + turning * swept;
    if (link.joint == JointType::kPrismatic) {
      swing.speed += std::abs(change);
      swing.bend += 2 * turning * std::abs(change);
      continue;
    }
    if (link.parallel != 0) {
      swing.base_turn += link.skew * (std::abs(change) + std::abs(base.turn));
      swing.turn = link.parallel * base.turn + change;
    } else {
      swing.base_turn = turning;
      swing.turn = change;
    }
    swing.turn_bend += std::abs(change) * swing.base_turn;
  }
}

template <int D>
Pace Chain<D>::pace(const ChainPiece<D>& piece, const Swing& swing) const {
  const double turning = swing.base_turn + std::abs(swing.turn);
  const double swept = swing.base_turn * piece.reach + std::abs(swing.turn) * piece.reach_across;
  return {(swing.speed + swept) * kRoundUp,
          (swing.bend + swing.turn_bend * piece.reach + turning * swept) * kRoundUp};
}

template void Chain<2>::place(const double*, Frame<2>*) const;
template void Chain<3>::place(const double*, Frame<3>*) const;
template Vec<2> Chain<2>::drift(const double*, const double*) const;
template Vec<3> Chain<3>::drift(const double*, const double*) const;
template void Chain<2>::twists(const double*, const Frame<2>*, Twist<2>*) const;
template void Chain<3>::twists(const double*, const Frame<3>*, Twist<3>*) const;
template void Chain<2>::swings(const double*, const double*, int, Swing*) const;
template void Chain<3>::swings(const double*, const double*, int, Swing*) const;
template Pace Chain<2>::pace(const ChainPiece<2>&, const Swing&) const;
template Pace Chain<3>::pace(const ChainPiece<3>&, const Swing&) const;

}  // namespace accord
