// Proofs that pairs of moving convex pieces keep apart throughout linear motions, or up to when:
// conservative advancement (Mirtich 1996), with bounds on motion per pair of pieces (Schwarzer,
// Saha and Latombe 2005) and, where those are too coarse, along the separating direction to second
// order: pieces that pass or part are then proved in a few steps, and contact is approached like
// Newton's method does.
//
// The way of the motion is a number u in [0, 1]. One Advancement serves one query at a time and
// keeps its memory for the next: a thread has one per dimension.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/box_tree.h"
#include "common/geometry/gap.h"
#include "common/geometry/traveller.h"

namespace accord {

// Two pieces that must keep apart.
template <int D>
struct Pair {
  enum class Other : unsigned char { kSame, kSecond, kFixed };
  int a;  // piece of the first traveller
  int b;  // piece of the first or second traveller, or fixed piece
  Other other;
  int ancestor = 0;                // kSame: the link in whose coordinates both move
  double keep = 0;                 // m, between the cores: radii and rounding included
  double speed = 0;                // m, how fast they can close, per unit of u
  double bend = 0;                 // m, how much that can change, per unit of u
  double from = 0;                 // march: proved up to here
  Vec<D> normal = Vec<D>::Zero();  // from the last look
};

template <int D>
class Advancement {
 public:
  Traveller<D> first;
  Traveller<D> second;
  bool two = false;  // whether the second one takes part
  std::span<const Placed<D>> fixed;
  std::vector<Pair<D>> pairs;
  std::vector<Swing> swings;       // scratch for whoever fills the pairs
  std::vector<Extent<D>> extents;  // likewise
  std::uint64_t distances = 0;     // distance queries made; whoever reads it sets it back

  void move_to(double u);                       // both travellers
  const Placed<D>& other(const Pair<D>& pair);  // the second piece, where it is now

  // Whether all pairs keep apart over [0, 1]. Looks at the middle first, so that a collision far
  // along is not found last.
  bool proves_free();
  // The u up to which all pairs are proved to keep apart; nullopt: all the way.
  std::optional<double> first_contact();

 private:
  // How far a look at one instant proves a pair apart, backwards and forwards.
  struct Cover {
    double back;
    double forward;
    bool contact;
  };
  struct Interval {
    double low = 0;
    double high = 0;
    std::size_t begin = 0;  // in ids_
    std::size_t end = 0;
  };

  Cover look(Pair<D>& pair, double back, double forward);
  // A piece's velocity, with its point `at` as the origin, in what the pair moves in.
  static Twist<D> velocity(Traveller<D>& traveller, const Pair<D>& pair, int piece,
                           const Vec<D>& at);
  void cover_along_normal(const Pair<D>& pair, const Placed<D>& a, const Placed<D>& b, double back,
                          double forward, Cover& cover);
  void start();
  bool split(const Interval& way, bool any, Interval& before, Interval& after);
  std::optional<double> march(const Interval& way);

  int looks_ = 0;
  std::vector<std::uint32_t> ids_;
  std::vector<std::uint32_t> later_;
  std::vector<Interval> intervals_;
};

// The calling thread's own.
template <int D>
Advancement<D>& thread_advancement();

}  // namespace accord
