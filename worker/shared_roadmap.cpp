#include "worker/shared_roadmap.h"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

#include "common/geometry/query_counter.h"

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

// A k-d tree, whatever its dimension.
class Tree {
 public:
  virtual ~Tree() = default;
  // The k nearest, nearest first, with the squares of their distances; returns how many.
  virtual std::size_t nearest(const double* point, std::size_t k, std::uint32_t* out,
                              double* squared) const = 0;
};

// Of a dimension known to the compiler, or of any: -1. Requires: `points` outlives it.
template <int kDimension>
class TreeOf final : public Tree {
 public:
  explicit TreeOf(const PointTable& points)
      : tree_(static_cast<int>(points.dimension), points,
              nanoflann::KDTreeSingleIndexAdaptorParams(kLeaf)) {}

  std::size_t nearest(const double* point, std::size_t k, std::uint32_t* out,
                      double* squared) const override {
    return tree_.knnSearch(point, k, out, squared);
  }

 private:
  static constexpr std::size_t kLeaf = 10;

  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointTable>, PointTable,
                                      kDimension, std::uint32_t>
      tree_;
};

std::unique_ptr<Tree> make_tree(const PointTable& points) {
  switch (points.dimension) {
    case 2:
      return std::make_unique<TreeOf<2>>(points);
    case 3:
      return std::make_unique<TreeOf<3>>(points);
    case 4:
      return std::make_unique<TreeOf<4>>(points);
    case 6:
      return std::make_unique<TreeOf<6>>(points);
    default:
      return std::make_unique<TreeOf<-1>>(points);
  }
}

}  // namespace

class SharedRoadmap::Index {
 public:
  Index(const CollisionWorld& world, RobotId robot, const std::vector<Configuration>& nodes)
      : embedding_(world, robot), points_{embedding_.dimension(), {}} {
    for (const Configuration& q : nodes) embedding_.append(q, points_.values);
    tree_ = make_tree(points_);
  }

  void nearest(ConfigurationView q, std::size_t k, std::vector<Node>& out) const {
    thread_local std::vector<double> point, squared;
    point.clear();
    embedding_.append(q, point);
    k = std::min(k, points_.kdtree_get_point_count());
    out.resize(k);
    squared.resize(k);
    if (k > 0) out.resize(tree_->nearest(point.data(), k, out.data(), squared.data()));
  }

 private:
  Embedding embedding_;
  PointTable points_;
  std::unique_ptr<Tree> tree_;
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
  // The edges that nodes lay, in the order of nodes; of a mutual pair only the first lays the edge.
  struct Laid {
    Node from, to;
    double duration;
  };
  std::vector<Laid> laid;
  std::vector<std::size_t> first_laid{0};  // by node, and one past the last
  const auto has_laid = [&](Node from, Node to) {
    const auto begin = laid.begin() + static_cast<std::ptrdiff_t>(first_laid[from]);
    const auto end = laid.begin() + static_cast<std::ptrdiff_t>(first_laid[from + 1]);
    return std::any_of(begin, end, [to](const Laid& edge) { return edge.to == to; });
  };
  std::vector<std::size_t> degree(nodes_.size(), 0);
  std::vector<Node> near;
  for (Node a = 0; a < size(); ++a) {
    nearest(nodes_[a], kNeighbours + 1, near);
    for (const Node b : near) {
      if (b == a || (b < a && has_laid(b, a))) continue;
      const double time = duration(nodes_[a], nodes_[b]);
      if (time <= 0) continue;
      laid.push_back({a, b, time});
      ++degree[a];
      ++degree[b];
    }
    first_laid.push_back(laid.size());
  }
  first_edge_.assign(1, 0);
  for (const std::size_t edges : degree) first_edge_.push_back(first_edge_.back() + edges);
  edges_.resize(first_edge_.back());
  std::vector<std::size_t> next(first_edge_.begin(), first_edge_.end() - 1);
  for (const Laid& edge : laid) {
    edges_[next[edge.from]++] = {edge.to, edge_count_, edge.duration};
    edges_[next[edge.to]++] = {edge.from, edge_count_, edge.duration};
    ++edge_count_;
  }
  proofs_ = std::make_unique<std::atomic<std::uint8_t>[]>(edge_count_);
}

bool SharedRoadmap::is_free(Node from, const RoadmapEdge& edge) const {
  std::uint8_t proof = proofs_[edge.id].load(std::memory_order_relaxed);
  if (proof != kUnknown) return proof == kFree;
  const std::lock_guard lock(provers_[edge.id % provers_.size()]);
  proof = proofs_[edge.id].load(std::memory_order_relaxed);
  if (proof == kUnknown) {
    const SeparateCost cost;
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
  thread_local Configuration delta;
  delta.resize(model_.dof());
  difference(model_, a, b, delta);
  return least_duration(model_, delta);
}

bool SharedRoadmap::motion_is_free(ConfigurationView a, ConfigurationView b) const {
  thread_local Configuration target;
  target.resize(model_.dof());
  nearest_representation(model_, a, b, target);
  return world_.motion_is_free(robot_, a, target);
}

}  // namespace accord
