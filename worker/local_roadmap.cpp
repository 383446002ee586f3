#include "worker/local_roadmap.h"

#include <algorithm>

namespace accord {
namespace {

// Nodes closer than this (m, in the metric) are the same place: a motion between them would take
// no time worth writing down.
constexpr double kSamePlace = 1e-4;

}  // namespace

LocalRoadmap::LocalRoadmap(const Team& team, const SharedRoadmap& base, const Region& region,
                           bool prove_ahead)
    : dof_(team.dof()),
      base_(&base),
      base_size_(base.size()),
      base_edges_(base.edge_count()),
      region_(region),
      prove_ahead_(prove_ahead) {}

bool LocalRoadmap::is_inside(ConfigurationView q) const {
  for (std::size_t k = 0; k < dof_; ++k) {
    if (q[k] < region_.lower[k] || q[k] > region_.upper[k]) return false;
  }
  return true;
}

std::span<const LocalRoadmap::Edge> LocalRoadmap::edges(Node node) const {
  if (node >= base_size_) return adjacency_[node - base_size_];
  const auto joined = base_joins_.find(node);
  return joined == base_joins_.end() ? base_->edges(node) : joined->second;
}

std::vector<LocalRoadmap::Edge>& LocalRoadmap::own_edges(Node node) {
  if (node >= base_size_) return adjacency_[node - base_size_];
  const auto [joined, is_new] = base_joins_.try_emplace(node);
  if (is_new) {
    const auto edges = base_->edges(node);
    joined->second.assign(edges.begin(), edges.end());
  }
  return joined->second;
}

LocalRoadmap::Node LocalRoadmap::add(const Team& team, ConfigurationView q, bool reuse) {
  if (reuse) {
    if (const auto known = find(team, q)) return *known;
  }
  configurations_.insert(configurations_.end(), q.begin(), q.end());
  constexpr std::size_t kUsualEdges = 8;
  adjacency_.emplace_back().reserve(kUsualEdges);
  return static_cast<Node>(size() - 1);
}

// A node at practically the same place.
std::optional<LocalRoadmap::Node> LocalRoadmap::find(const Team& team, ConfigurationView q) const {
  const auto is_there = [&](Node node) {
    return team.squared_distance(configuration(node), q) < kSamePlace * kSamePlace;
  };
  for (Node node = base_size_; node < size(); ++node) {
    if (is_there(node)) return node;
  }
  if (base_ == nullptr) return std::nullopt;
  base_->nearest(q, 1, base_near_);
  if (base_near_.empty() || !is_there(base_near_[0])) return std::nullopt;
  return base_near_[0];
}

void LocalRoadmap::connect(const Team& team, Node a, Node b, bool proved) {
  if (a == b) return;
  if (std::ranges::any_of(edges(a), [b](const Edge& edge) { return edge.to == b; })) return;
  target_.resize(dof_);
  team.nearest_representation(configuration(a), configuration(b), target_);
  const double duration = team.duration(configuration(a), target_);
  if (duration <= 0) return;
  const auto id = static_cast<std::uint32_t>(base_edges_ + proofs_.size());
  proofs_.push_back(proved ? Proof::kFree : Proof::kUnknown);
  own_edges(a).push_back({b, id, duration});
  own_edges(b).push_back({a, id, duration});
}

void LocalRoadmap::connect_nearest(const Team& team, Node node, std::size_t k) {
  nearest(team, configuration(node), k, node, neighbours_);
  for (const Node neighbour : neighbours_) connect(team, node, neighbour);
}

void LocalRoadmap::nearest(const Team& team, ConfigurationView q, std::size_t k, Node limit,
                           std::vector<Node>& out) const {
  ranked_.clear();
  const auto rank = [&](Node node) {
    ranked_.emplace_back(team.squared_distance(configuration(node), q), node);
  };
  if (base_ != nullptr) {
    base_->nearest(q, k, base_near_);
    std::ranges::for_each(base_near_, rank);
  }
  for (Node node = base_size_; node < limit; ++node) rank(node);
  k = std::min(k, ranked_.size());
  std::partial_sort(ranked_.begin(), ranked_.begin() + static_cast<std::ptrdiff_t>(k),
                    ranked_.end());
  out.clear();
  for (std::size_t i = 0; i < k; ++i) out.push_back(ranked_[i].second);
}

bool LocalRoadmap::is_free(const Team& team, Node from, const Edge& edge) {
  if (edge.id < base_edges_) {
    if (!is_inside(configuration(edge.to))) return false;
    ++motion_checks_;
    const bool free = base_->is_free(from, edge);
    if (!free && !prove_ahead_) base_blocked_.insert(edge.id);
    return free;
  }
  Proof& proof = proofs_[edge.id - base_edges_];
  if (proof == Proof::kUnknown) {
    ++motion_checks_;
    target_.resize(dof_);
    team.nearest_representation(configuration(from), configuration(edge.to), target_);
    const bool free = team.motion_is_free(configuration(from), target_);
    proof = free ? Proof::kFree : Proof::kBlocked;
  }
  return proof == Proof::kFree;
}

bool LocalRoadmap::is_blocked(Node from, const Edge& edge) const {
  if (edge.id >= base_edges_) return proofs_[edge.id - base_edges_] == Proof::kBlocked;
  if (!is_inside(configuration(edge.to)) || !is_inside(configuration(from))) return true;
  return prove_ahead_ ? !base_->is_free(from, edge) : base_blocked_.contains(edge.id);
}

}  // namespace accord
