// Priority inheritance with backtracking (PIBT; Okumura, Machida, Defago and Tamura 2022) for discs
// and balls: all robots move in lockstep, one edge of a lattice a step. Whoever has waited longest
// goes first; whoever is in its way inherits its rank, and has to go somewhere else before it does.
//
// Other than in the original
// * robots come from and go to places off the lattice, so that what gets in each other's way is
//   decided by geometry: two motions of one step conflict where the bodies would come too close at
//   any instant of it, in closed form; and a robot off the lattice may be pushed to other such
//   places;
// * where a robot in the way is too close to get out of it in time, it may do so while the one that
//   asks waits for a step;
// * some decisions are perturbed, by a seeded draw, so that robots do not push each other back and
//   forth for ever;
// * nodes next to others' goals cost more: who has parked there would have to be pushed away.
// Not thread safe.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/geometry/distance_tally.h"
#include "worker/lattice.h"
#include "worker/lattice_ways.h"

namespace accord {

class Lockstep {
 public:
  // What moves: from its start to its goal, clear of all others' starts and goals.
  struct Traveller {
    RobotId robot;
    Vec3 start;
    Vec3 goal;
  };

  // Both must outlive this. Requires: all are discs or balls no larger than the lattice was made
  // for.
  Lockstep(const CollisionWorld& world, const Lattice& lattice,
           const std::vector<Traveller>& travellers, std::uint64_t seed);
  ~Lockstep();

  // Moves all until they get no closer to their goals, or `stop`. False: someone has no way to its
  // goal.
  bool run(const std::atomic<bool>& stop);

  // Afterwards, of each traveller: where it was before the first step and after each.
  std::vector<std::vector<Vec3>> take_steps();
  // Those who had not arrived, and the rest of their ways, past everyone else, by traveller.
  std::vector<std::vector<Vec3>> ways_left() const;

  // Moves considered.
  std::uint64_t moves() const { return moves_; }

 private:
  using Node = LatticeWays::Node;
  struct Agent;
  struct Push;

  void step();
  void rank();
  void find_neighbours();
  bool decide(std::size_t i, const Push* push);
  void list_candidates(std::size_t i, bool is_pushed, std::vector<Node>& out) const;
  bool try_move(std::size_t i, Node to);
  bool try_clearing(std::size_t i, Node to);
  bool push_away(std::size_t j, const Push& push);
  bool try_displaced(std::size_t i, const Push& push);
  bool are_in_conflict(const Agent& agent, Node to, const Agent& other) const;
  bool is_in_the_way(const Agent& agent, Node to, const Vec3& place, const Agent& other) const;
  double distance_to_keep(const Agent& a, const Agent& b) const;
  void choose(std::size_t i, Node to);
  void undo(std::size_t decisions);
  std::uint64_t cost_left() const;

  const CollisionWorld& world_;
  const Lattice& lattice_;
  std::uint64_t seed_;
  std::vector<std::uint32_t> weights_;  // by node of the lattice
  std::vector<Agent> agents_;
  std::vector<std::size_t> order_;    // by rank
  std::vector<std::size_t> decided_;  // in this step, in the order of decisions
  double reach_ = 0;       // m: two that are farther apart before a step cannot conflict in it
  std::size_t chain_ = 0;  // of robots that push each other at the moment
  std::uint64_t steps_ = 0;
  std::uint64_t moves_ = 0;
  mutable DistanceTally tally_;
  std::uint64_t most_moves_ = 0;  // until the end of this step
};

}  // namespace accord
