// A regular grid of places for discs or balls, for many to move on in lockstep: every edge takes
// the same time.
// Immutable after construction; thread safe.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/collision_world.h"

namespace accord {

class Lattice {
 public:
  using Node = std::uint32_t;

  // All places of a grid of the given spacing (m) in `box` that are free for `robot`, with edges
  // along the axes where the motion is. The grid begins at the box's lower corner.
  // Requires: the robot is a disc or a ball, spacing > 0, the box holds at most kMostPlaces.
  Lattice(const CollisionWorld& world, RobotId robot, const Aabb& box, double spacing);

  static constexpr std::size_t kMostPlaces = 200'000;
  // How many places a grid would have, free or not. May be infinite.
  static double places(const Aabb& box, double spacing, std::size_t dimensions);

  Node size() const { return static_cast<Node>(positions_.size()); }
  double spacing() const { return spacing_; }
  const Vec3& position(Node node) const { return positions_[node]; }
  std::span<const Node> neighbours(Node node) const {
    return {neighbours_.data() + first_[node], first_[node + 1] - first_[node]};
  }

  // All nodes within a distance (m) of a point, nearest first.
  void within(const Vec3& point, double distance, std::vector<Node>& out) const;

 private:
  static constexpr Node kNone = ~Node{0};

  Node at(const Eigen::Array<std::int64_t, 3, 1>& cell) const;
  void lay_lines(const CollisionWorld& world, RobotId robot, const Aabb& box, double spacing);

  std::array<std::vector<double>, 3> lines_;
  double spacing_;
  Eigen::Array<std::int64_t, 3, 1> counts_;  // cells along each axis
  std::vector<Node> nodes_;                  // by cell; kNone where it is not free
  std::vector<Vec3> positions_;              // by node
  std::vector<std::uint32_t> first_;         // by node: where its neighbours begin
  std::vector<Node> neighbours_;
};

}  // namespace accord
