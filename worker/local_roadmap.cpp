#include "worker/local_roadmap.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace accord {
namespace {

// Nodes closer than this (m, in the metric) are the same place: a motion between them would take
// no time worth writing down.
constexpr double kSamePlace = 1e-4;

}  // namespace

LocalRoadmap::Node LocalRoadmap::add(const Team& team, ConfigurationView q, bool reuse) {
  if (reuse) {
    for (Node node = 0; node < size(); ++node) {
      if (team.squared_distance(configuration(node), q) < kSamePlace * kSamePlace) return node;
    }
  }
  configurations_.insert(configurations_.end(), q.begin(), q.end());
  adjacency_.emplace_back();
  times_to_.clear();
  return static_cast<Node>(size() - 1);
}

void LocalRoadmap::connect(const Team& team, Node a, Node b, bool proved) {
  if (a == b) return;
  const auto leads_to_b = [b](const Edge& edge) { return edge.to == b; };
  if (std::ranges::any_of(adjacency_[a], leads_to_b)) return;
  target_.resize(dof_);
  team.nearest_representation(configuration(a), configuration(b), target_);
  const double duration = team.duration(configuration(a), target_);
  if (duration <= 0) return;
  const auto id = static_cast<std::uint32_t>(proofs_.size());
  times_to_.clear();
  proofs_.push_back(proved ? Proof::kFree : Proof::kUnknown);
  adjacency_[a].push_back({b, id, duration});
  adjacency_[b].push_back({a, id, duration});
}

void LocalRoadmap::connect_nearest(const Team& team, Node node, std::size_t k) {
  nearest(team, configuration(node), k, node, neighbours_);
  for (const Node neighbour : neighbours_) connect(team, node, neighbour);
}

void LocalRoadmap::nearest(const Team& team, ConfigurationView q, std::size_t k, Node limit,
                           std::vector<Node>& out) const {
  ranked_.clear();
  for (Node node = 0; node < limit; ++node) {
    ranked_.emplace_back(team.squared_distance(configuration(node), q), node);
  }
  k = std::min(k, ranked_.size());
  std::partial_sort(ranked_.begin(), ranked_.begin() + static_cast<std::ptrdiff_t>(k),
                    ranked_.end());
  out.clear();
  for (std::size_t i = 0; i < k; ++i) out.push_back(ranked_[i].second);
}

const std::vector<double>& LocalRoadmap::times_to(Node goal) {
  if (!times_to_.empty() && times_goal_ == goal) return times_to_;
  times_goal_ = goal;
  times_to_.assign(size(), std::numeric_limits<double>::infinity());
  using Reached = std::pair<double, Node>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  times_to_[goal] = 0;
  open.emplace(0, goal);
  while (!open.empty()) {
    const auto [time, node] = open.top();
    open.pop();
    if (time > times_to_[node]) continue;
    for (const Edge& edge : adjacency_[node]) {
      const double through = time + edge.duration;
      if (through >= times_to_[edge.to] || proofs_[edge.id] == Proof::kBlocked) continue;
      times_to_[edge.to] = through;
      open.emplace(through, edge.to);
    }
  }
  return times_to_;
}

bool LocalRoadmap::is_free(const Team& team, Node from, const Edge& edge) {
  Proof& proof = proofs_[edge.id];
  if (proof == Proof::kUnknown) {
    ++motion_checks_;
    target_.resize(dof_);
    team.nearest_representation(configuration(from), configuration(edge.to), target_);
    const bool free = team.motion_is_free(configuration(from), target_);
    proof = free ? Proof::kFree : Proof::kBlocked;
  }
  return proof == Proof::kFree;
}

}  // namespace accord
