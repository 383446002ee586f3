// A graph of free configurations of one robot that many may search at once. Nodes and edges never
// change; an edge's motion is proved when first asked for, and remembered.
// Thread safe.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "common/geometry/collision_world.h"

namespace accord {

// From a node of a roadmap to another.
struct RoadmapEdge {
  std::uint32_t to;
  std::uint32_t id;  // shared by both directions
  double duration;   // s, at the robot's limits
};

class SharedRoadmap {
 public:
  using Node = std::uint32_t;

  // Lays edges between each node and its nearest neighbours, in a metric that weighs each degree of
  // freedom by how far it moves the body. `robot` stands for all that share the roadmap.
  // Requires: nodes are free.
  SharedRoadmap(const CollisionWorld& world, RobotId robot, std::vector<Configuration> nodes);
  ~SharedRoadmap();

  Node size() const { return static_cast<Node>(nodes_.size()); }
  std::uint32_t edge_count() const { return edge_count_; }
  ConfigurationView configuration(Node node) const { return nodes_[node]; }
  std::span<const RoadmapEdge> edges(Node node) const {
    return {edges_.data() + first_edge_[node], edges_.data() + first_edge_[node + 1]};
  }

  // Whether an edge's motion is free.
  bool is_free(Node from, const RoadmapEdge& edge) const;

  // The k nearest nodes, nearest first; fewer where there are fewer.
  void nearest(ConfigurationView q, std::size_t k, std::vector<Node>& out) const;

  // The least time (s) between two configurations, the short way round where the robot may turn.
  double duration(ConfigurationView a, ConfigurationView b) const;
  // Whether the motion between them is free.
  bool motion_is_free(ConfigurationView a, ConfigurationView b) const;

  const RobotModel& model() const { return model_; }

 private:
  class Index;
  enum Proof : std::uint8_t { kUnknown, kFree, kBlocked };

  void connect();

  const CollisionWorld& world_;
  RobotId robot_;
  const RobotModel& model_;
  std::vector<Configuration> nodes_;
  std::unique_ptr<Index> index_;
  std::vector<RoadmapEdge> edges_;       // by node
  std::vector<std::size_t> first_edge_;  // by node, and one past the last
  std::uint32_t edge_count_ = 0;
  std::unique_ptr<std::atomic<std::uint8_t>[]> proofs_;  // by edge id
  // Held while an edge is proved, by edge id: each is proved once, so that what it takes to solve a
  // scene, all in all, does not depend on who asks when.
  mutable std::array<std::mutex, 32> provers_;
};

}  // namespace accord
