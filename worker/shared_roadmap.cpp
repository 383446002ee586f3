#include "worker/shared_roadmap.h"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

namespace accord {
namespace {

constexpr std::size_t kNeighbours = 12;

// Places configurations in a Euclidean space in which distance stands for motion of the body:
// degrees of freedom weighed by reach, those that wrap laid round a circle.
class Embedding {
 public:
  Embedding(const CollisionWorld& world, RobotId robot)
      : model_(*world.scene().robot(robot).model), reach_(world.reach(robot)) {}

  std::size_t dimension() const {
    std::size_t n = 0;
    for (const DegreeOfFreedom& dof : model_.dofs) n += dof.wraps ? 2 : 1;
    return n;
  }

  void append(ConfigurationView q, std::vector<double>& out) const {
    for (std::size_t k = 0; k < model_.dof(); ++k) {
      if (model_.dofs[k].wraps) {
        out.push_back(reach_[k] * std::cos(q[k]));
        out.push_back(reach_[k] * std::sin(q[k]));
      } else {
        out.push_back(reach_[k] * q[k]);
      }
    }
  }

 private:
  const RobotModel& model_;
  std::span<const double> reach_;
};

// Points as nanoflann wants to see them.
struct PointTable {
  std::size_t dimension;
  std::vector<double> values;

  std::size_t kdtree_get_point_count() const { return values.size() / dimension; }
  double kdtree_get_pt(std::size_t i, std::size_t k) const { return values[i * dimension + k]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using KdTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointTable>,
                                                   PointTable, -1, std::uint32_t>;

}  // namespace

class SharedRoadmap::Index {
 public:
  Index(const CollisionWorld& world, RobotId robot, const std::vector<Configuration>& nodes)
      : embedding_(world, robot), points_{embedding_.dimension(), {}} {
    for (const Configuration& q : nodes) embedding_.append(q, points_.values);
    constexpr std::size_t kLeaf = 10;
    tree_ = std::make_unique<KdTree>(static_cast<int>(points_.dimension), points_,
                                     nanoflann::KDTreeSingleIndexAdaptorParams(kLeaf));
  }

  void nearest(ConfigurationView q, std::size_t k, std::vector<Node>& out) const {
    std::vector<double> point;
    embedding_.append(q, point);
    k = std::min(k, points_.kdtree_get_point_count());
    out.resize(k);
    std::vector<double> squared(k);
    if (k > 0) out.resize(tree_->knnSearch(point.data(), k, out.data(), squared.data()));
  }

 private:
  Embedding embedding_;
  PointTable points_;
  std::unique_ptr<KdTree> tree_;
};

SharedRoadmap::SharedRoadmap(const CollisionWorld& world, RobotId robot,
                             std::vector<Configuration> nodes)
    : world_(world),
      robot_(robot),
      model_(*world.scene().robot(robot).model),
      nodes_(std::move(nodes)),
      index_(std::make_unique<Index>(world, robot, nodes_)) {
  connect();
}

SharedRoadmap::~SharedRoadmap() = default;

void SharedRoadmap::connect() {
  edges_.resize(nodes_.size());
  std::vector<Node> near;
  for (Node a = 0; a < size(); ++a) {
    nearest(nodes_[a], kNeighbours + 1, near);
    for (const Node b : near) {
      // Of a mutual pair only the first lays the edge.
      const auto leads_to_b = [b](const RoadmapEdge& edge) { return edge.to == b; };
      if (b == a || std::ranges::any_of(edges_[a], leads_to_b)) continue;
      const double time = duration(nodes_[a], nodes_[b]);
      if (time <= 0) continue;
      edges_[a].push_back({b, edge_count_, time});
      edges_[b].push_back({a, edge_count_, time});
      ++edge_count_;
    }
  }
  proofs_ = std::make_unique<std::atomic<std::uint8_t>[]>(edge_count_);
}

bool SharedRoadmap::is_free(Node from, const RoadmapEdge& edge) const {
  std::uint8_t proof = proofs_[edge.id].load(std::memory_order_relaxed);
  if (proof != kUnknown) return proof == kFree;
  const std::lock_guard lock(provers_[edge.id % provers_.size()]);
  proof = proofs_[edge.id].load(std::memory_order_relaxed);
  if (proof == kUnknown) {
    // Always asked in the same direction, so that all threads and processes agree.
    const Node a = std::min(from, edge.to), b = std::max(from, edge.to);
    proof = motion_is_free(nodes_[a], nodes_[b]) ? kFree : kBlocked;
    proofs_[edge.id].store(proof, std::memory_order_relaxed);
  }
  return proof == kFree;
}

void SharedRoadmap::nearest(ConfigurationView q, std::size_t k, std::vector<Node>& out) const {
  index_->nearest(q, k, out);
}

double SharedRoadmap::duration(ConfigurationView a, ConfigurationView b) const {
  Configuration delta(model_.dof());
  difference(model_, a, b, delta);
  return least_duration(model_, delta);
}

bool SharedRoadmap::motion_is_free(ConfigurationView a, ConfigurationView b) const {
  Configuration target(model_.dof());
  nearest_representation(model_, a, b, target);
  return world_.motion_is_free(robot_, a, target);
}

}  // namespace accord
