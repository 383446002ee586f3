// Watches how a roadmap's connected components grow and tells when sampling has stopped paying:
// each new node creates a component, merges some, expands one, or oversamples what is covered
// (Morales, Pearce and Amato, ICRA 2006).
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "common/model/configuration.h"

namespace accord {

enum class NodeClass : std::uint8_t { kCreate, kMerge, kExpand, kOversample };

class RoadmapEvolution {
 public:
  // `window`: the number of latest nodes that are looked at.
  explicit RoadmapEvolution(std::size_t window) : window_(window) {}

  // A new node, in a component of its own for now; `weighted` is its place in the metric.
  std::size_t add(ConfigurationView weighted);
  bool connected(std::size_t a, std::size_t b) { return find(a) == find(b); }
  // A proved motion between two nodes.
  void join(std::size_t a, std::size_t b);

  // Classifies the newest node from what connecting it brought: the number of components it was
  // joined to, and whether any attempt failed.
  NodeClass classify(std::size_t joined, bool any_failed, bool grew);
  // The extent of a node's component: the diagonal of its bounding box, standing for its diameter.
  double diameter(std::size_t node);

  // Over the last window: create, merge and expand below a few percent together, no merge at all,
  // and the largest component's diameter no longer growing.
  bool has_settled() const;

 private:
  struct Component {
    Configuration lower, upper;
  };
  struct Record {
    NodeClass node_class;
    double largest_diameter;
  };

  std::size_t find(std::size_t node);
  static double diagonal(const Component& component);

  std::size_t window_;
  std::vector<std::size_t> parents_;
  std::vector<Component> components_;  // valid at roots
  std::deque<Record> records_;
  double largest_diameter_ = 0;
};

}  // namespace accord
