// A graph of free configurations of a team inside a subproblem. Edges are laid between neighbours
// and proved only when a search wants to use them (lazy PRM; Bohlin and Kavraki 2000).
// Not thread safe; lives as long as one solution attempt.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/planning/subproblem.h"
#include "worker/team.h"

namespace accord {

class LocalRoadmap {
 public:
  using Node = std::uint32_t;

  struct Edge {
    Node to;
    std::uint32_t id;  // shared by both directions
    double duration;   // s
  };

  explicit LocalRoadmap(const Team& team) : dof_(team.dof()) {}

  std::size_t size() const { return adjacency_.size(); }
  ConfigurationView configuration(Node node) const {
    return {configurations_.data() + node * dof_, dof_};
  }
  const std::vector<Edge>& edges(Node node) const { return adjacency_[node]; }

  // Adds a configuration that is known to be free. Returns the node; an existing one when q is
  // practically the same place (and `reuse`).
  Node add(const Team& team, ConfigurationView q, bool reuse = true);

  // Lays an edge unless there is one; `proved` when the caller has proved its motion.
  void connect(const Team& team, Node a, Node b, bool proved = false);

  // Connects a node to its k nearest neighbours among the nodes before it.
  void connect_nearest(const Team& team, Node node, std::size_t k);

  // The k nearest among the nodes [0, limit), nearest first.
  void nearest(const Team& team, ConfigurationView q, std::size_t k, Node limit,
               std::vector<Node>& out) const;

  // Whether an edge's motion is free; proved once and remembered.
  bool is_free(const Team& team, Node from, const Edge& edge);

  // By node: the least time (s) along edges not known to be blocked to `goal`; infinite where no
  // edges lead there. Kept for further calls with the same goal while the roadmap does not change.
  // A lower bound still after more edges have been proved.
  const std::vector<double>& times_to(Node goal);

  std::uint64_t motion_checks() const { return motion_checks_; }

 private:
  enum class Proof : std::uint8_t { kUnknown, kFree, kBlocked };

  std::size_t dof_;
  std::vector<double> configurations_;
  std::vector<std::vector<Edge>> adjacency_;
  std::vector<Proof> proofs_;  // by edge id
  std::uint64_t motion_checks_ = 0;
  std::vector<double> times_to_;  // by node; empty: not known
  Node times_goal_ = 0;
  Configuration target_;                                 // scratch
  mutable std::vector<std::pair<double, Node>> ranked_;  // scratch
  std::vector<Node> neighbours_;                         // scratch
};

}  // namespace accord
