// What a chain can touch: itself, and the space round it.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/geometry/chain.h"

namespace accord {
namespace {

int common_ancestor(int a, int b, const auto& links) {
  while (a != b) {  // parents come before children
    if (a > b) {
      a = links[static_cast<std::size_t>(a)].parent;
    } else {
      b = links[static_cast<std::size_t>(b)].parent;
    }
  }
  return a;
}

}  // namespace

template <int D>
void Chain<D>::find_self_pairs(const RobotModel& model) {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    for (std::size_t j = i + 1; j < pieces_.size(); ++j) {
      const int la = pieces_[i].link;
      const int lb = pieces_[j].link;
      if (la == lb) continue;
      const int a = model.bodies[static_cast<std::size_t>(pieces_[i].body)].link;
      const int b = model.bodies[static_cast<std::size_t>(pieces_[j].body)].link;
      if (model.may_touch.contains({std::min(a, b), std::max(a, b)})) continue;
      self_pairs_.push_back(
          {static_cast<int>(i), static_cast<int>(j), common_ancestor(la, lb, links_)});
    }
  }
  std::sort(self_pairs_.begin(), self_pairs_.end(), [](const SelfPair& p, const SelfPair& q) {
    return std::tie(p.ancestor, p.a, p.b) < std::tie(q.ancestor, q.a, q.b);
  });
}

// For each piece: the chain from its link down to the root. Lengths add up along it to how far the
// piece can be from each joint on the way.
template <int D>
void Chain<D>::find_reach(const RobotModel& model) {
  reach_.assign(model.dof(), mobile() ? 1.0 : 0.0);
  if (kind_ == RobotKind::kFootprint) {
    reach_[2] = 0;
    for (const auto& p : pieces_) reach_[2] = std::max(reach_[2], p.reach + p.piece.radius);
  }
  if (mobile()) return;
  Extent<D> all = Extent<D>::nothing();
  for (const auto& p : pieces_) {
    double length = p.reach + p.piece.radius;
    Vec<D> center = Vec<D>::Zero();
    if (p.link == 0) {  // at rest: its own extent
      const Vec<D> half = half_extents(Placed<D>{&p.piece, p.piece.frame});
      all.merge(Extent<D>{p.piece.frame.t - half, p.piece.frame.t + half}.inflated(p.piece.radius));
      continue;
    }
    for (int i = p.link; i > 0; i = links_[static_cast<std::size_t>(i)].parent) {
      const ChainLink<D>& link = links_[static_cast<std::size_t>(i)];
      const auto dof = static_cast<std::size_t>(link.dof);
      double range = 0;
      if (link.joint == JointType::kPrismatic) {
        reach_[dof] = 1;
        range = std::max(std::abs(model.dofs[dof].lower), std::abs(model.dofs[dof].upper));
      } else {
        reach_[dof] = std::max(reach_[dof], length);
      }
      length += range + (link.parent == 0 ? 0.0 : link.origin.t.norm());
      center = link.origin.t;  // of the last, which the root carries: in the world
    }
    all.merge(Extent<D>{center, center}.inflated(length));
  }
  reach_box_ = all;
}

template void Chain<2>::find_self_pairs(const RobotModel&);
template void Chain<3>::find_self_pairs(const RobotModel&);
template void Chain<2>::find_reach(const RobotModel&);
template void Chain<3>::find_reach(const RobotModel&);

}  // namespace accord
