#include "worker/roadmap_query.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace accord {
namespace {

class Query {
 public:
  using Node = SharedRoadmap::Node;

  Query(const SharedRoadmap& roadmap, ConfigurationView start, ConfigurationView goal,
        Effort& effort)
      : roadmap_(roadmap),
        start_(start),
        goal_(goal),
        effort_(effort),
        goal_node_(roadmap.size()),
        cost_(roadmap.size() + 1, std::numeric_limits<double>::infinity()),
        parent_(roadmap.size() + 1, kStart),
        closed_(roadmap.size() + 1, 0),
        joins_goal_(roadmap.size(), 0) {}

  std::optional<std::vector<Configuration>> run() {
    std::vector<Node> near;
    roadmap_.nearest(goal_, kJoins, near);
    for (const Node node : near) joins_goal_[node] = 1;
    roadmap_.nearest(start_, kJoins, near);
    for (const Node node : near) {
      if (is_free(start_, at(node))) relax(kStart, node, roadmap_.duration(start_, at(node)));
    }
    while (!open_.empty()) {
      const Node node = open_.top().second;
      open_.pop();
      if (closed_[node]) continue;
      closed_[node] = 1;
      if (node == goal_node_) return trace();
      ++effort_.expansions;
      expand(node);
    }
    return std::nullopt;
  }

 private:
  static constexpr Node kStart = std::numeric_limits<Node>::max();
  static constexpr std::size_t kJoins = 16;
  using Entry = std::pair<double, Node>;

  ConfigurationView at(Node node) const { return roadmap_.configuration(node); }

  bool is_free(ConfigurationView a, ConfigurationView b) {
    ++effort_.motion_checks;
    return roadmap_.motion_is_free(a, b);
  }

  void expand(Node node) {
    if (joins_goal_[node]) {
      const double cost = cost_[node] + roadmap_.duration(at(node), goal_);
      if (cost < cost_[goal_node_] && is_free(at(node), goal_)) relax(node, goal_node_, cost);
    }
    for (const RoadmapEdge& edge : roadmap_.edges(node)) {
      if (closed_[edge.to] || cost_[node] + edge.duration >= cost_[edge.to]) continue;
      // Counted whether or not another query has had it proved: effort is the same on every
      // machine.
      ++effort_.motion_checks;
      if (!roadmap_.is_free(node, edge)) continue;
      relax(node, edge.to, cost_[node] + edge.duration);
    }
  }

  void relax(Node from, Node to, double cost) {
    if (cost >= cost_[to]) return;
    cost_[to] = cost;
    parent_[to] = from;
    const double rest = to == goal_node_ ? 0 : roadmap_.duration(at(to), goal_);
    open_.emplace(cost + rest, to);
  }

  std::vector<Configuration> trace() const {
    std::vector<Node> nodes;
    for (Node n = parent_[goal_node_]; n != kStart; n = parent_[n]) nodes.push_back(n);
    std::ranges::reverse(nodes);
    std::vector<Configuration> path{Configuration(start_.begin(), start_.end())};
    const auto append = [&](ConfigurationView q) {
      Configuration next(q.size());
      nearest_representation(roadmap_.model(), path.back(), q, next);
      path.push_back(std::move(next));
    };
    for (const Node node : nodes) append(at(node));
    append(goal_);
    return path;
  }

  const SharedRoadmap& roadmap_;
  ConfigurationView start_, goal_;
  Effort& effort_;
  Node goal_node_;
  std::vector<double> cost_;
  std::vector<Node> parent_;
  std::vector<char> closed_;
  std::vector<char> joins_goal_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

std::optional<std::vector<Configuration>> shortest_path(const SharedRoadmap& roadmap,
                                                        ConfigurationView start,
                                                        ConfigurationView goal, Effort& effort) {
  ++effort.searches;
  return Query(roadmap, start, goal, effort).run();
}

}  // namespace accord
