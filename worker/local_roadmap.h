// A graph of free configurations of a team inside a subproblem. Edges are laid between neighbours
// and proved only when a search wants to use them (lazy PRM; Bohlin and Kavraki 2000). May stand on
// a shared roadmap of a team's only robot, to which it adds nodes and edges of its own.
// Not thread safe; lives as long as one solution attempt. What it answers depends on what it was
// asked before, never on what other threads have asked of the shared roadmap.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "common/planning/subproblem.h"
#include "worker/shared_roadmap.h"
#include "worker/team.h"

namespace accord {

class LocalRoadmap {
 public:
  using Node = SharedRoadmap::Node;
  using Edge = RoadmapEdge;

  explicit LocalRoadmap(const Team& team) : dof_(team.dof()) {}

  // On a shared roadmap, whose nodes are the first ones; edges to those outside the region count as
  // blocked. With `prove_ahead` is_blocked() proves the base's edges, which pays where proofs are
  // cheap.
  // Requires: a team of one robot that shares `base`, which must outlive this.
  LocalRoadmap(const Team& team, const SharedRoadmap& base, const Region& region, bool prove_ahead);

  // The first node that is not the base's.
  Node first_own() const { return base_size_; }
  std::size_t size() const { return base_size_ + adjacency_.size(); }
  ConfigurationView configuration(Node node) const {
    if (node < base_size_) return base_->configuration(node);
    return {configurations_.data() + (node - base_size_) * dof_, dof_};
  }
  // Valid until the next edge is laid.
  std::span<const Edge> edges(Node node) const;

  // Adds a configuration that is known to be free. Returns the node; an existing one when q is
  // practically the same place (and `reuse`).
  Node add(const Team& team, ConfigurationView q, bool reuse = true);

  // Lays an edge unless there is one; `proved` when the caller has proved its motion.
  void connect(const Team& team, Node a, Node b, bool proved = false);

  // Connects a node to its k nearest neighbours among the nodes before it.
  void connect_nearest(const Team& team, Node node, std::size_t k);

  // The k nearest among the nodes [0, limit), nearest first. Requires: limit >= size of the base.
  void nearest(const Team& team, ConfigurationView q, std::size_t k, Node limit,
               std::vector<Node>& out) const;

  // Whether an edge's motion is free; proved once and remembered.
  bool is_free(const Team& team, Node from, const Edge& edge);

  // Whether an edge is known to be blocked: from proofs asked for here, or, where edges of the base
  // are proved ahead, now.
  bool is_blocked(Node from, const Edge& edge) const;

  // Proofs asked for, whether or not the shared roadmap knew the answer.
  std::uint64_t motion_checks() const { return motion_checks_; }

 private:
  enum class Proof : std::uint8_t { kUnknown, kFree, kBlocked };

  bool is_inside(ConfigurationView q) const;
  std::optional<Node> find(const Team& team, ConfigurationView q) const;
  std::vector<Edge>& own_edges(Node node);

  std::size_t dof_;
  const SharedRoadmap* base_ = nullptr;
  Node base_size_ = 0;
  std::uint32_t base_edges_ = 0;
  Region region_;
  bool prove_ahead_ = false;
  std::unordered_set<std::uint32_t> base_blocked_;          // edges of the base found blocked here
  std::unordered_map<Node, std::vector<Edge>> base_joins_;  // base's and own edges of the base's
                                                            // nodes that have own ones
  std::vector<double> configurations_;                      // own nodes, row by row
  std::vector<std::vector<Edge>> adjacency_;                // of own nodes
  std::vector<Proof> proofs_;                               // of own edges
  std::uint64_t motion_checks_ = 0;
  Configuration target_;                                 // scratch
  mutable std::vector<std::pair<double, Node>> ranked_;  // scratch
  mutable std::vector<Node> base_near_;                  // scratch
  std::vector<Node> neighbours_;                         // scratch
};

}  // namespace accord
