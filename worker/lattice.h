// A grid of places for discs or balls to move on in lockstep: no edge is longer than the lattice's
// spacing, so that every motion along one can take the same time.
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

  // The places in `box` where lines cross that are at least `least` (m) apart, those that are free
  // for `robot`, with edges along the lines where the motion is. The lines are laid where they pass
  // through most free space: an aisle wide enough for two gets two.
  // Requires: the robot is a disc or a ball, least > 0, places() is at most kMostPlaces.
  Lattice(const CollisionWorld& world, RobotId robot, const Aabb& box, double least);

  static constexpr double kMostPlaces = 200'000;
  // An upper bound on the number of places, free or not. May be infinite.
  static double places(const Aabb& box, double least, std::size_t dimensions);

  Node size() const { return static_cast<Node>(positions_.size()); }
  double spacing() const { return spacing_; }  // m: of the two neighbouring lines farthest apart
  const Vec3& position(Node node) const { return positions_[node]; }
  std::span<const Node> neighbours(Node node) const {
    return {neighbours_.data() + first_[node], first_[node + 1] - first_[node]};
  }

  // All nodes within a distance (m) of a point, nearest first.
  void within(const Vec3& point, double distance, std::vector<Node>& out) const;

 private:
  static constexpr Node kNone = ~Node{0};
  using Index = std::array<std::size_t, 3>;  // of a line across each axis

  void lay_lines(const CollisionWorld& world, RobotId robot, const Aabb& box, double least);
  std::size_t cell(const Index& index) const {
    return index[0] + lines_[0].size() * (index[1] + lines_[1].size() * index[2]);
  }
  Vec3 crossing(const Index& index) const {
    return {lines_[0][index[0]], lines_[1][index[1]], lines_[2][index[2]]};
  }
  template <class Visit>
  static void for_each(const Index& lower, const Index& upper, const Visit& visit);

  std::array<std::vector<double>, 3> lines_;  // m: where they cross each axis
  double spacing_ = 0;
  std::vector<Node> nodes_;         // by cell; kNone where it is not free
  std::vector<Vec3> positions_;     // by node
  std::vector<std::size_t> first_;  // by node: where its neighbours begin
  std::vector<Node> neighbours_;
};

}  // namespace accord
