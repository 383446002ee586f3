// Which obstacles and bounds a motion has to be proved against: all that boxes and capsules swept
// over the whole motion do not rule out.
#include <algorithm>
#include <cmath>

#include "common/geometry/mesh_surface.h"
#include "common/geometry/sweep.h"
#include "common/geometry/tolerances.h"
#include "common/geometry/world_core.h"

namespace accord {
namespace {

// Bodies may reach this far beyond the bounds: rounding of those that lie against them.
constexpr double kBoundsTolerance = 1e-9;  // m

template <int D>
Pair<D> fixed_pair(int piece, int fixed, double keep, double speed, double bend) {
  Pair<D> pair;
  pair.a = piece;
  pair.b = fixed;
  pair.other = Pair<D>::Other::kFixed;
  pair.keep = keep;
  pair.speed = speed;
  pair.bend = bend;
  return pair;
}

// The points that a disc's or ball's centre passes over.
Placed<2> track(const Vec<2>& from, const Vec<2>& to, Piece<2>& piece) {
  const Vec<2> way = to - from;
  const double length = way.norm();
  Frame<2> frame;
  frame.t = (from + to) / 2;
  if (length > 0) {
    piece.core = Core::kSegment;
    piece.half.x() = length / 2;
    piece.bound = piece.half.x();
    frame.c = way.x() / length;
    frame.s = way.y() / length;
  }
  return {&piece, frame};
}

Placed<3> track(const Vec<3>& from, const Vec<3>& to, Piece<3>& piece) {
  const Vec<3> way = to - from;
  const double length = way.norm();
  Frame<3> frame;
  frame.t = (from + to) / 2;
  if (length > 0) {
    piece.core = Core::kSegment;
    piece.half.x() = length / 2;
    piece.bound = piece.half.x();
    frame.r.col(2) = way / length;  // segments have no other axes
  }
  return {&piece, frame};
}

}  // namespace

template <int D>
void WorldCore<D>::add_walls_for(int piece, const Extent<D>& swept, double speed, double bend,
                                 Work& work) const {
  if (!bounds_) return;
  const auto& p = work.first.chain().pieces()[static_cast<std::size_t>(piece)];
  const int first = static_cast<int>(obstacle_of_.size());
  for (int axis = 0; axis < D; ++axis) {
    const double keep = p.piece.radius - kBoundsTolerance;
    if (swept.min[axis] < bounds_->min[axis]) {
      work.pairs.push_back(fixed_pair<D>(piece, first + 2 * axis, keep, speed, bend));
    }
    if (swept.max[axis] > bounds_->max[axis]) {
      work.pairs.push_back(fixed_pair<D>(piece, first + 2 * axis + 1, keep, speed, bend));
    }
  }
}

// Every point of a piece stays near the chord between its ends: within an eighth of how much its
// path can bend, and within half of how far it can go.
template <int D>
void WorldCore<D>::sweep_pieces(Work& work) const {
  const int count = static_cast<int>(work.first.chain().pieces().size());
  work.extents.resize(static_cast<std::size_t>(count));
  work.first.move_to(0);
  for (int i = 0; i < count; ++i) {
    const Placed<D>& placed = work.first.piece(i);
    const Vec<D> half = half_extents(placed);
    work.extents[static_cast<std::size_t>(i)] = {placed.frame.t - half, placed.frame.t + half};
  }
  if (!work.first.resting()) work.first.move_to(1);
  for (int i = 0; i < count; ++i) {
    Extent<D>& extent = work.extents[static_cast<std::size_t>(i)];
    if (!work.first.resting()) {
      const Placed<D>& placed = work.first.piece(i);
      const Vec<D> half = half_extents(placed);
      extent.merge({placed.frame.t - half, placed.frame.t + half});
    }
    const Pace& pace = work.first.pace(i);
    const double radius = work.first.chain().pieces()[static_cast<std::size_t>(i)].piece.radius;
    extent = extent.inflated(radius + std::min(pace.bend / 8, pace.speed / 2));
  }
}

template <int D>
void WorldCore<D>::add_fixed_pairs(RobotId robot, Work& work) const {
  if (near_fixed_[robot.index()] == 0) return;
  sweep_pieces(work);
  const double drift = work.first.drift().norm();
  for (std::size_t i = 0; i < work.extents.size(); ++i) {
    const int piece = static_cast<int>(i);
    const double radius = work.first.chain().pieces()[i].piece.radius;
    const double speed = work.first.pace(piece).speed + drift;
    const double bend = work.first.pace(piece).bend;
    add_walls_for(piece, work.extents[i], speed, bend, work);
    tree_.each_overlapping(work.extents[i].inflated(apart_), [&](int fixed) {
      const double other = fixed_pieces_[static_cast<std::size_t>(fixed)].radius;
      work.pairs.push_back(fixed_pair<D>(piece, fixed, apart_ + radius + other, speed, bend));
      return true;
    });
  }
}

// Discs and balls sweep capsules, so that one distance settles a whole motion; only what the
// capsule touches is left to be advanced against.
template <int D>
bool WorldCore<D>::add_disc_pairs(RobotId robot, bool only_one, Work& work) const {
  const double radius = chains_[robot.index()].radius();
  const Eigen::Map<const Vec<D>> from(work.first.from());
  const Eigen::Map<const Vec<D>> to(work.first.to());
  const Sweep<D> sweep(from, to, radius + apart_);
  const double speed = work.first.drift().norm();
  add_walls_for(0, sweep.extent().inflated(-apart_), speed, 0, work);
  Piece<D> piece;
  const Placed<D> swept = track(from, to, piece);
  return tree_.each_meeting(sweep, [&](int fixed) {
    const Placed<D>& obstacle = fixed_[static_cast<std::size_t>(fixed)];
    const double keep = apart_ + radius + obstacle.piece->radius;
    ++work.distances;
    const Wanted wanted{keep + kContactResolution, keep, 1e-10, 0, false};
    const bool clear = gap(swept, obstacle, wanted, Vec<D>(Vec<D>::Zero())).distance > keep;
    if (clear && !(solids_ && contains(obstacle, swept))) return true;
    work.pairs.push_back(fixed_pair<D>(0, fixed, keep, speed, 0));
    return !only_one;
  });
}

template void WorldCore<2>::add_fixed_pairs(RobotId, Work&) const;
template void WorldCore<3>::add_fixed_pairs(RobotId, Work&) const;
template bool WorldCore<2>::add_disc_pairs(RobotId, bool, Work&) const;
template bool WorldCore<3>::add_disc_pairs(RobotId, bool, Work&) const;
template void WorldCore<2>::sweep_pieces(Work&) const;
template void WorldCore<3>::sweep_pieces(Work&) const;

}  // namespace accord
