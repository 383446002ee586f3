// Frames and velocities in two and three dimensions under one interface, so that kinematics and
// motion proofs are written once and planar scenes pay for no third dimension.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "common/geometry/sincos.h"

namespace accord {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;

// A rigid transformation: maps points of its own coordinates to those of its parent.
template <int D>
struct Frame;

template <>
struct Frame<2> {
  double c = 1;  // first axis: (c, s); second: (-s, c)
  double s = 0;
  Vec<2> t = Vec<2>::Zero();

  Vec<2> rotate(const Vec<2>& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
  Vec<2> unrotate(const Vec<2>& v) const { return {c * v.x() + s * v.y(), c * v.y() - s * v.x()}; }
  Vec<2> operator()(const Vec<2>& p) const { return t + rotate(p); }
  Vec<2> inverse(const Vec<2>& p) const { return unrotate(p - t); }
  Frame operator*(const Frame& f) const {
    return {c * f.c - s * f.s, s * f.c + c * f.s, (*this)(f.t)};
  }
  // The direction along which segments lie.
  Vec<2> axis() const { return {c, s}; }
};

template <>
struct Frame<3> {
  Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
  Vec<3> t = Vec<3>::Zero();

  Vec<3> rotate(const Vec<3>& v) const { return r * v; }
  Vec<3> unrotate(const Vec<3>& v) const { return r.transpose() * v; }
  Vec<3> operator()(const Vec<3>& p) const { return t + rotate(p); }
  Vec<3> inverse(const Vec<3>& p) const { return unrotate(p - t); }
  Frame operator*(const Frame& f) const { return {r * f.r, (*this)(f.t)}; }
  // The direction along which segments and cylinders lie.
  Vec<3> axis() const { return r.col(2); }
};

inline Frame<3> frame_of(const Eigen::Isometry3d& pose) {
  return {pose.linear(), pose.translation()};
}

// How a rigid body moves at an instant: the velocity of its frame's origin and its rotation.
template <int D>
struct Twist;

template <>
struct Twist<2> {
  Vec<2> linear = Vec<2>::Zero();
  double angular = 0;

  // The velocity of the point at `arm` from the origin.
  Vec<2> at(const Vec<2>& arm) const {
    return {linear.x() - angular * arm.y(), linear.y() + angular * arm.x()};
  }
  // The m for which n . (rotation x p) = m . p for every p.
  Vec<2> turn(const Vec<2>& n) const { return {angular * n.y(), -angular * n.x()}; }
};

template <>
struct Twist<3> {
  Vec<3> linear = Vec<3>::Zero();
  Vec<3> angular = Vec<3>::Zero();

  Vec<3> at(const Vec<3>& arm) const { return linear + angular.cross(arm); }
  Vec<3> turn(const Vec<3>& n) const { return n.cross(angular); }
};

}  // namespace accord
