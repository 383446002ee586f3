#include "common/geometry/traveller.h"

#include <algorithm>

namespace accord {

template <int D>
void Traveller<D>::start(const Chain<D>& chain, ConfigurationView from, ConfigurationView to) {
  chain_ = &chain;
  from_ = from.data();
  to_ = to.data();
  drift_ = chain.drift(from_, to_);
  if (chain_id_ != chain.id()) {
    chain_id_ = chain.id();
    placed_for_ = false;
  }
  q_.resize(from.size());
  next_q_.resize(from.size());
  delta_.resize(from.size());
  resting_ = true;
  for (std::size_t i = 0; i < from.size(); ++i) {
    delta_[i] = to[i] - from[i];
    if (delta_[i] != 0) resting_ = false;
  }
  const std::size_t links = chain.links().size();
  const std::size_t pieces = chain.pieces().size();
  if (frames_.size() < links) {
    frames_.resize(links);
    twists_.resize(links);
    swings_.resize(links);
  }
  if (placed_.size() < pieces) {
    placed_.resize(pieces);
    placed_stamp_.resize(pieces, stamp_);
    paces_.resize(pieces);
  }
  u_ = -1;
  twisted_ = false;
  if (resting_) {
    std::fill_n(paces_.begin(), pieces, Pace{});
    return;
  }
  chain.swings(from_, to_, -1, swings_.data());
  for (std::size_t i = 0; i < pieces; ++i) {
    const ChainPiece<D>& piece = chain.pieces()[i];
    paces_[i] = chain.pace(piece, swings_[static_cast<std::size_t>(piece.link)]);
  }
}

template <int D>
void Traveller<D>::move_to(double u) {
  if (resting_) u = 0;
  if (u == u_) return;
  u_ = u;
  twisted_ = false;
  for (std::size_t i = 0; i < q_.size(); ++i) {
    next_q_[i] = u == 1 ? to_[i] : from_[i] + u * delta_[i];
  }
  if (placed_for_ && next_q_ == q_) return;  // where the last query left it
  q_.swap(next_q_);
  placed_for_ = true;
  ++stamp_;
  chain_->place(q_.data(), frames_.data());
}

template <int D>
const Placed<D>& Traveller<D>::piece(int i) {
  const auto k = static_cast<std::size_t>(i);
  if (placed_stamp_[k] != stamp_) {
    const ChainPiece<D>& p = chain_->pieces()[k];
    placed_[k] = {&p.piece, frames_[static_cast<std::size_t>(p.link)] * p.piece.frame};
    placed_stamp_[k] = stamp_;
  }
  return placed_[k];
}

template <int D>
const Twist<D>& Traveller<D>::twist(int link) {
  if (!twisted_) {
    chain_->twists(delta_.data(), frames_.data(), twists_.data());
    twisted_ = true;
  }
  return twists_[static_cast<std::size_t>(link)];
}

template class Traveller<2>;
template class Traveller<3>;

}  // namespace accord
