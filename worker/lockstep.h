// Priority inheritance with backtracking (PIBT; Okumura, Machida, Defago and Tamura 2019/2022) for
// discs and balls: all robots move in lockstep, one edge of a lattice a step. Whoever has waited
// longest goes first, and whoever is in its way takes over its rank and goes before it.
//
// Other than in the original, robots come and go off the lattice (their starts and goals are where
// they are), so that what gets in each other's way is decided by geometry: two motions of one step
// conflict where the bodies would come too close at any instant of it, in closed form.
// Not thread safe.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/collision_world.h"
#include "worker/lattice.h"

namespace accord {

class Lockstep {
 public:
  // What moves: from its start to its goal, both free and clear of all others' starts and goals.
  struct Traveller {
    RobotId robot;
    Vec3 start;
    Vec3 goal;
  };

  // Both must outlive this. Requires: all are discs or balls no larger than the lattice was made
  // for.
  Lockstep(const CollisionWorld& world, const Lattice& lattice, std::vector<Traveller> travellers);
  ~Lockstep();

  // Each traveller's places, one a step, the first its start and the last its goal; all of the same
  // length. nullopt where someone cannot get on the lattice and to its goal, or when not all have
  // arrived after `most_steps`, or at `stop`.
  std::optional<std::vector<std::vector<Vec3>>> run(std::size_t most_steps,
                                                    const std::atomic<bool>& stop);

  // Moves considered so far.
  std::uint64_t moves() const { return moves_; }

 private:
  using Node = std::uint32_t;  // of the lattice, or from its size on a traveller's own
  struct Agent;
  struct Push;

  bool join(Agent& agent);
  bool link_goal(Agent& agent);
  std::optional<Node> visit(Agent& agent, const Vec3& point, double most);
  int steps_between(const Vec3& a, const Vec3& b) const;
  bool motion_is_free(const Agent& agent, const Vec3& from, const Vec3& to) const;
  void find_distances(Agent& agent);
  void step();
  void find_neighbours();
  bool decide(std::uint32_t i, const Push* push);
  bool try_displacement(std::uint32_t i, const Vec3& displacement, const Push& push);
  bool try_clearing(std::uint32_t i, Node to);
  bool try_move(std::uint32_t i, Node to);
  bool conflicts(const Agent& agent, Node to, const Agent& other) const;
  void choose(std::uint32_t i, Node to);
  void undo(std::size_t trail);
  const Vec3& position(const Agent& agent, Node node) const;
  std::uint32_t distance(const Agent& agent, Node node) const;
  Node best_next(const Agent& agent) const;
  std::size_t arrived() const;

  const CollisionWorld& world_;
  const Lattice& lattice_;
  std::vector<Agent> agents_;
  std::vector<std::uint32_t> order_;    // by rank
  std::vector<std::uint32_t> decided_;  // in this step, in the order of decisions
  double reach_ = 0;                    // m: farther apart at a step's start, two cannot conflict
  std::uint64_t steps_ = 0; bool trace_ = false;
  std::uint64_t moves_ = 0;
  std::uint64_t moves_left_ = 0;  // in this step
};

}  // namespace accord
