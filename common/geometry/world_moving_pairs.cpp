// Which pairs of moving bodies a motion has to be proved for: all that balls swept over the whole
// motion do not rule out. And what surfaces do not tell: who is inside of whom.
#include <algorithm>
#include <cmath>

#include "common/geometry/mesh_surface.h"
#include "common/geometry/world_core.h"

namespace accord {

template <int D>
void WorldCore<D>::add_self_pairs(Work& work) const {
  const Chain<D>& chain = work.first.chain();
  if (chain.self_pairs().empty()) return;
  work.first.move_to(0.5);
  work.swings.resize(std::max(work.swings.size(), chain.links().size()));
  int ancestor = -1;
  for (const SelfPair& self : chain.self_pairs()) {
    if (self.ancestor != ancestor) {
      ancestor = self.ancestor;
      chain.swings(work.first.from(), work.first.to(), ancestor, work.swings.data());
    }
    const auto& a = chain.pieces()[static_cast<std::size_t>(self.a)];
    const auto& b = chain.pieces()[static_cast<std::size_t>(self.b)];
    const Pace pace_a = chain.pace(a, work.swings[static_cast<std::size_t>(a.link)]);
    const Pace pace_b = chain.pace(b, work.swings[static_cast<std::size_t>(b.link)]);
    Pair<D> pair;
    pair.a = self.a;
    pair.b = self.b;
    pair.other = Pair<D>::Other::kSame;
    pair.ancestor = ancestor;
    pair.keep = self_apart_ + a.piece.radius + b.piece.radius;
    pair.speed = pace_a.speed + pace_b.speed;
    pair.bend = pace_a.bend + pace_b.bend;
    const double far = a.piece.bound + b.piece.bound + pair.keep + pair.speed / 2;
    const Vec<D> offset = work.first.center(self.b) - work.first.center(self.a);
    if (offset.squaredNorm() <= far * far) work.pairs.push_back(pair);
  }
}

template <int D>
void WorldCore<D>::add_robot_pairs(Work& work) const {
  Traveller<D>& first = work.first;
  Traveller<D>& second = work.second;
  first.move_to(0.5);
  second.move_to(0.5);
  const auto a_pieces = first.chain().pieces();
  const auto b_pieces = second.chain().pieces();
  // Balls about the pieces' centres that hold them all the way; b moves, as seen from a, with
  // drift.
  const double drift = (second.drift() - first.drift()).norm();
  work.extents.resize(b_pieces.size());
  Extent<D> all = Extent<D>::nothing();
  for (std::size_t j = 0; j < b_pieces.size(); ++j) {
    const int b = static_cast<int>(j);
    const Vec<D> center = second.center(b);
    const double ball = b_pieces[j].piece.bound + b_pieces[j].piece.radius +
                        (second.pace(b).speed + drift) / 2 + apart_;
    work.extents[j] = Extent<D>{center, center};
    all.merge(work.extents[j].inflated(ball));
  }
  for (std::size_t i = 0; i < a_pieces.size(); ++i) {
    const int a = static_cast<int>(i);
    const Vec<D> center = first.center(a);
    const Pace& pace = first.pace(a);
    const double ball = a_pieces[i].piece.bound + a_pieces[i].piece.radius + pace.speed / 2;
    if (all.squared_distance({center, center}) > ball * ball) continue;
    for (std::size_t j = 0; j < b_pieces.size(); ++j) {
      const Pace& other = second.pace(static_cast<int>(j));
      Pair<D> pair;
      pair.a = a;
      pair.b = static_cast<int>(j);
      pair.other = Pair<D>::Other::kSecond;
      pair.keep = apart_ + a_pieces[i].piece.radius + b_pieces[j].piece.radius;
      pair.speed = pace.speed + other.speed + drift;
      pair.bend = pace.bend + other.bend;
      const double far =
          a_pieces[i].piece.bound + b_pieces[j].piece.bound + pair.keep + pair.speed / 2;
      if ((work.extents[j].min - center).squaredNorm() <= far * far) work.pairs.push_back(pair);
    }
  }
}

template <int D>
bool WorldCore<D>::contains(const Placed<D>& solid, const Placed<D>& other) {
  if constexpr (D == 3) {
    const MeshSurface* mesh = solid.piece->mesh.get();
    if (mesh == nullptr || !mesh->closed() || other.piece->core == Core::kHalfSpace) return false;
    const MeshSurface* inner = other.piece->mesh.get();
    const Vec3 point = inner != nullptr ? other.frame(inner->some_point()) : other.frame.t;
    return mesh->contains(solid.frame.inverse(point));
  }
  return false;
}

template <int D>
bool WorldCore<D>::swallowed(Work& work) const {
  if (!solids_) return false;
  work.move_to(0);
  for (const Pair<D>& pair : work.pairs) {
    const Placed<D>& a = work.first.piece(pair.a);
    const Placed<D>& b = work.other(pair);
    if (contains(a, b) || contains(b, a)) return true;
  }
  return false;
}

template void WorldCore<2>::add_self_pairs(Work&) const;
template void WorldCore<3>::add_self_pairs(Work&) const;
template void WorldCore<2>::add_robot_pairs(Work&) const;
template void WorldCore<3>::add_robot_pairs(Work&) const;
template bool WorldCore<2>::swallowed(Work&) const;
template bool WorldCore<3>::swallowed(Work&) const;
template bool WorldCore<2>::contains(const Placed<2>&, const Placed<2>&);
template bool WorldCore<3>::contains(const Placed<3>&, const Placed<3>&);

}  // namespace accord
