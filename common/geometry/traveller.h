// One robot on a linear motion: where its links and pieces are at an instant, and how they move.
// The way of the motion is a number u in [0, 1]. Everything is computed when first asked for, in
// memory that is kept for the next motion, and frames too where that begins at the same place. One
// thread at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/chain.h"

namespace accord {

template <int D>
class Traveller {
 public:
  void start(const Chain<D>& chain, ConfigurationView from, ConfigurationView to);
  void move_to(double u);

  const Chain<D>& chain() const { return *chain_; }
  bool resting() const { return resting_; }
  const double* from() const { return from_; }
  const double* to() const { return to_; }
  const Vec<D>& drift() const { return drift_; }
  const Placed<D>& piece(int i);
  const Vec<D> center(int i) const {  // of a piece
    const ChainPiece<D>& p = chain_->pieces()[static_cast<std::size_t>(i)];
    return frames_[static_cast<std::size_t>(p.link)](p.piece.frame.t);
  }
  const Twist<D>& twist(int link);
  const Pace& pace(int i) const { return paces_[static_cast<std::size_t>(i)]; }  // without drift
  const Frame<D>& frame(int link) const { return frames_[static_cast<std::size_t>(link)]; }

 private:
  const Chain<D>* chain_ = nullptr;
  std::uint64_t chain_id_ = 0;  // of the chain that the frames are of
  const double* from_ = nullptr;
  const double* to_ = nullptr;
  Vec<D> drift_ = Vec<D>::Zero();
  double u_ = -1;
  bool resting_ = false;
  std::uint32_t stamp_ = 0;
  bool twisted_ = false;
  bool placed_for_ = false;  // frames_ are of q_
  std::vector<double> q_;
  std::vector<double> next_q_;
  std::vector<double> delta_;
  std::vector<Frame<D>> frames_;
  std::vector<Placed<D>> placed_;
  std::vector<std::uint32_t> placed_stamp_;
  std::vector<Twist<D>> twists_;
  std::vector<Swing> swings_;
  std::vector<Pace> paces_;
};

}  // namespace accord
