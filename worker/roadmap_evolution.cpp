#include "worker/roadmap_evolution.h"

#include <algorithm>
#include <cmath>

namespace accord {
namespace {

constexpr double kProductiveShare = 0.05;  // "a few percent"
constexpr double kGrowth = 1.01;           // a diameter within this factor has not grown

}  // namespace

std::size_t RoadmapEvolution::add(ConfigurationView weighted) {
  parents_.push_back(parents_.size());
  components_.push_back({{weighted.begin(), weighted.end()}, {weighted.begin(), weighted.end()}});
  return parents_.size() - 1;
}

std::size_t RoadmapEvolution::find(std::size_t node) {
  while (parents_[node] != node) node = parents_[node] = parents_[parents_[node]];
  return node;
}

void RoadmapEvolution::join(std::size_t a, std::size_t b) {
  std::size_t root = find(a), other = find(b);
  if (root == other) return;
  if (other < root) std::swap(root, other);
  parents_[other] = root;
  for (std::size_t k = 0; k < components_[root].lower.size(); ++k) {
    components_[root].lower[k] = std::min(components_[root].lower[k], components_[other].lower[k]);
    components_[root].upper[k] = std::max(components_[root].upper[k], components_[other].upper[k]);
  }
  largest_diameter_ = std::max(largest_diameter_, diagonal(components_[root]));
}

double RoadmapEvolution::diagonal(const Component& component) {
  double sum = 0;
  for (std::size_t k = 0; k < component.lower.size(); ++k) {
    const double extent = component.upper[k] - component.lower[k];
    sum += extent * extent;
  }
  return std::sqrt(sum);
}

double RoadmapEvolution::diameter(std::size_t node) {
  return diagonal(components_[find(node)]);
}

NodeClass RoadmapEvolution::classify(std::size_t joined, bool any_failed, bool grew) {
  NodeClass result = NodeClass::kOversample;
  if (joined == 0) {
    result = NodeClass::kCreate;
  } else if (joined > 1) {
    result = NodeClass::kMerge;
  } else if (any_failed && grew) {
    result = NodeClass::kExpand;
  }
  records_.push_back({result, largest_diameter_});
  if (records_.size() > window_) records_.pop_front();
  return result;
}

bool RoadmapEvolution::has_settled() const {
  if (records_.size() < window_) return false;
  const auto count = [this](NodeClass wanted) {
    return std::ranges::count(records_, wanted, &Record::node_class);
  };
  if (count(NodeClass::kMerge) > 0) return false;
  const auto productive = count(NodeClass::kCreate) + count(NodeClass::kExpand);
  if (static_cast<double>(productive) > kProductiveShare * static_cast<double>(window_)) {
    return false;
  }
  return largest_diameter_ <= kGrowth * records_.front().largest_diameter;
}

}  // namespace accord
