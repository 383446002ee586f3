// One robot's ways to its goal on a lattice that it shares with others: its start and goal lie off
// the lattice, and so may places that it has to give way to. A step leads to a neighbouring node,
// or to a place no farther away than the lattice's spacing.
// Not thread safe.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/collision_world.h"
#include "worker/lattice.h"

namespace accord {

class LatticeWays {
 public:
  // Of the lattice, or from its size on a place of the robot's own.
  using Node = std::uint32_t;

  // `weights`: what it costs to step on each node of the lattice, at least 1. All must outlive
  // this. Requires: the robot is a disc or a ball no larger than the lattice was made for.
  LatticeWays(const CollisionWorld& world, const Lattice& lattice,
              const std::vector<std::uint32_t>& weights, RobotId robot, const Vec3& start,
              const Vec3& goal);

  // nullopt: there is no way from the start to the goal.
  std::optional<Node> start() const { return start_; }
  Node goal() const { return lattice_.size(); }
  RobotId robot() const { return robot_; }

  const Vec3& position(Node node) const;
  // Of the cheapest way to the goal. Only of nodes that there is a way from.
  std::uint32_t cost(Node node) const;
  bool is_off(Node node) const { return node >= lattice_.size(); }

  // Where a step can lead from a node.
  void next(Node node, std::vector<Node>& out) const;
  // Where it leads on the cheapest way to the goal. Requires: not at the goal.
  Node best_next(Node node) const;

  // The place that lies by `displacement` from a node, where the motion there is free, and a step
  // leads on from there.
  std::optional<Node> displaced(Node node, const Vec3& displacement);

 private:
  // Off the lattice.
  struct Place {
    Vec3 position;
    std::vector<Node> next;
    std::uint32_t cost;
  };

  Node add(Place place);
  void link_goal();
  void find_costs();
  std::optional<Node> visit(const Vec3& position, double spacings);
  bool motion_is_free(const Vec3& from, const Vec3& to) const;
  int steps_between(const Vec3& from, const Vec3& to) const;

  const CollisionWorld& world_;
  const Lattice& lattice_;
  const std::vector<std::uint32_t>& weights_;
  RobotId robot_;
  std::size_t dof_;
  std::vector<Place> places_;                   // the goal, the start, and others
  std::vector<std::pair<Node, Node>> entries_;  // from the lattice to places
  std::vector<std::uint32_t> costs_;            // by node of the lattice
  std::optional<Node> start_;
};

}  // namespace accord
