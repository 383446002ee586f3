#include "worker/robot_roadmap.h"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>
#include <numbers>
#include <queue>

#include "common/planning/random.h"
#include "common/planning/region.h"
#include "worker/free_samples.h"

namespace accord {
namespace {

// Nodes of level 0, and the factor from level to level.
constexpr std::size_t kNodesPerDof = 400;
constexpr std::size_t kGrowth = 4;
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

struct RobotRoadmap::Level {
  struct Edge {
    std::uint32_t to;
    std::uint32_t id;
    double duration;
  };
  enum Proof : std::uint8_t { kUnknown, kFree, kBlocked };

  Level(const CollisionWorld& w, RobotId r, std::size_t samples)
      : world(w), robot(r), model(*w.scene().robot(r).model), embedding(w, r) {
    nodes = free_samples(w, r, samples);
    points.dimension = embedding.dimension();
    for (const Configuration& q : nodes) embedding.append(q, points.values);
    tree = std::make_unique<KdTree>(static_cast<int>(points.dimension), points,
                                    nanoflann::KDTreeSingleIndexAdaptorParams(10));
    connect();
  }

  void connect() {
    edges.resize(nodes.size());
    std::vector<std::uint32_t> near;
    for (std::uint32_t a = 0; a < nodes.size(); ++a) {
      nearest(nodes[a], kNeighbours + 1, near);
      for (const std::uint32_t b : near) {
        // Of a mutual pair only the first lays the edge.
        if (b == a || std::ranges::any_of(edges[a], [b](const Edge& e) { return e.to == b; })) {
          continue;
        }
        const double time = duration(nodes[a], nodes[b]);
        if (time <= 0) continue;
        edges[a].push_back({b, edge_count, time});
        edges[b].push_back({a, edge_count, time});
        ++edge_count;
      }
    }
    proofs = std::make_unique<std::atomic<std::uint8_t>[]>(edge_count);
  }

  void nearest(ConfigurationView q, std::size_t k, std::vector<std::uint32_t>& out) const {
    std::vector<double> point;
    embedding.append(q, point);
    k = std::min(k, nodes.size());
    out.resize(k);
    std::vector<double> squared(k);
    if (k > 0) out.resize(tree->knnSearch(point.data(), k, out.data(), squared.data()));
  }

  double duration(ConfigurationView a, ConfigurationView b) const {
    Configuration delta(model.dof());
    difference(model, a, b, delta);
    return least_duration(model, delta);
  }

  bool motion_is_free(ConfigurationView a, ConfigurationView b, Effort& effort) const {
    Configuration target(model.dof());
    nearest_representation(model, a, b, target);
    ++effort.motion_checks;
    return world.motion_is_free(robot, a, target);
  }

  bool edge_is_free(std::uint32_t from, const Edge& edge, Effort& effort) const {
    std::uint8_t proof = proofs[edge.id].load(std::memory_order_relaxed);
    if (proof == kUnknown) {
      // Always asked in the same direction, so that all threads and processes agree.
      const std::uint32_t a = std::min(from, edge.to), b = std::max(from, edge.to);
      proof = motion_is_free(nodes[a], nodes[b], effort) ? kFree : kBlocked;
      proofs[edge.id].store(proof, std::memory_order_relaxed);
    }
    return proof == kFree;
  }

  const CollisionWorld& world;
  RobotId robot;
  const RobotModel& model;
  Embedding embedding;
  std::vector<Configuration> nodes;
  std::vector<std::vector<Edge>> edges;
  std::uint32_t edge_count = 0;
  PointTable points;
  std::unique_ptr<KdTree> tree;
  std::unique_ptr<std::atomic<std::uint8_t>[]> proofs;
};

namespace {

// A* from the start over a level's nodes to the goal. Start and goal are joined to their
// neighbours for this query alone: the shared roadmap does not change.
template <class Level>
class Query {
 public:
  Query(const Level& level, ConfigurationView start, ConfigurationView goal, Effort& effort)
      : level_(level),
        start_(start),
        goal_(goal),
        effort_(effort),
        goal_node_(static_cast<std::uint32_t>(level.nodes.size())),
        cost_(level.nodes.size() + 1, std::numeric_limits<double>::infinity()),
        parent_(level.nodes.size() + 1, kStart),
        closed_(level.nodes.size() + 1, 0),
        joins_goal_(level.nodes.size(), 0) {}

  std::optional<std::vector<Configuration>> run() {
    std::vector<std::uint32_t> near;
    level_.nearest(goal_, kJoins, near);
    for (const std::uint32_t node : near) joins_goal_[node] = 1;
    level_.nearest(start_, kJoins, near);
    for (const std::uint32_t node : near) {
      if (level_.motion_is_free(start_, level_.nodes[node], effort_)) {
        relax(kStart, node, level_.duration(start_, level_.nodes[node]));
      }
    }
    while (!open_.empty()) {
      const std::uint32_t node = open_.top().second;
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
  static constexpr std::uint32_t kStart = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kJoins = 16;
  using Entry = std::pair<double, std::uint32_t>;

  void expand(std::uint32_t node) {
    if (joins_goal_[node]) {
      const double cost = cost_[node] + level_.duration(level_.nodes[node], goal_);
      if (cost < cost_[goal_node_] && level_.motion_is_free(level_.nodes[node], goal_, effort_)) {
        relax(node, goal_node_, cost);
      }
    }
    for (const auto& edge : level_.edges[node]) {
      if (closed_[edge.to] || cost_[node] + edge.duration >= cost_[edge.to]) continue;
      if (!level_.edge_is_free(node, edge, effort_)) continue;
      relax(node, edge.to, cost_[node] + edge.duration);
    }
  }

  void relax(std::uint32_t from, std::uint32_t to, double cost) {
    if (cost >= cost_[to]) return;
    cost_[to] = cost;
    parent_[to] = from;
    const double rest = to == goal_node_ ? 0 : level_.duration(level_.nodes[to], goal_);
    open_.emplace(cost + rest, to);
  }

  std::vector<Configuration> trace() const {
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t n = parent_[goal_node_]; n != kStart; n = parent_[n]) nodes.push_back(n);
    std::ranges::reverse(nodes);
    std::vector<Configuration> path{Configuration(start_.begin(), start_.end())};
    const auto append = [&](ConfigurationView q) {
      Configuration next(q.size());
      nearest_representation(level_.model, path.back(), q, next);
      path.push_back(std::move(next));
    };
    for (const std::uint32_t node : nodes) append(level_.nodes[node]);
    append(goal_);
    return path;
  }

  const Level& level_;
  ConfigurationView start_, goal_;
  Effort& effort_;
  std::uint32_t goal_node_;
  std::vector<double> cost_;
  std::vector<std::uint32_t> parent_;
  std::vector<char> closed_;
  std::vector<char> joins_goal_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

std::size_t samples_of_level(const RobotModel& model, std::size_t level) {
  std::size_t samples = kNodesPerDof * model.dof();
  for (std::size_t i = 0; i < level; ++i) samples *= kGrowth;
  return samples;
}

std::size_t first_dense_level(const CollisionWorld& world, RobotId id) {
  const Robot& robot = world.scene().robot(id);
  const Aabb body = world.swept_bounds(id, robot.start, robot.start);
  const Region whole = whole_region(world.scene(), id);
  double bodies = 1;  // that fill the space
  for (std::size_t k = 0; k < robot.model->translations(); ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    bodies *= (whole.upper[k] - whole.lower[k]) / (body.max[axis] - body.min[axis]);
  }
  std::size_t level = 0;
  while (level + 1 < RobotRoadmap::kLevels &&
         static_cast<double>(samples_of_level(*robot.model, level)) < bodies) {
    ++level;
  }
  return level;
}

}  // namespace

RobotRoadmap::RobotRoadmap(const CollisionWorld& world, RobotId robot)
    : world_(world),
      robot_(robot),
      dense_level_(first_dense_level(world, robot)),
      levels_(kLevels) {}

RobotRoadmap::~RobotRoadmap() = default;

const RobotRoadmap::Level& RobotRoadmap::level(std::size_t index) const {
  const std::lock_guard lock(mutex_);
  if (!levels_[index]) {
    const std::size_t samples = samples_of_level(*world_.scene().robot(robot_).model, index);
    levels_[index] = std::make_unique<Level>(world_, robot_, samples);
  }
  return *levels_[index];
}

void RobotRoadmap::copy_into(std::size_t index, const Region& region, const Team& team,
                             LocalRoadmap& out) const {
  constexpr LocalRoadmap::Node kOutside = std::numeric_limits<LocalRoadmap::Node>::max();
  const Level& from = level(index);
  std::vector<LocalRoadmap::Node> copies(from.nodes.size(), kOutside);
  const auto inside = [&](const Configuration& q) {
    for (std::size_t k = 0; k < q.size(); ++k) {
      if (q[k] < region.lower[k] || q[k] > region.upper[k]) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < from.nodes.size(); ++i) {
    if (inside(from.nodes[i])) copies[i] = out.add(team, from.nodes[i], false);
  }
  for (std::size_t i = 0; i < from.nodes.size(); ++i) {
    if (copies[i] == kOutside) continue;
    for (const Level::Edge& edge : from.edges[i]) {
      if (edge.to < i || copies[edge.to] == kOutside) continue;
      const std::uint8_t proof = from.proofs[edge.id].load(std::memory_order_relaxed);
      if (proof == Level::kBlocked) continue;
      out.connect(team, copies[i], copies[edge.to], proof == Level::kFree);
    }
  }
}

std::optional<std::vector<Configuration>> RobotRoadmap::query(std::size_t index,
                                                              ConfigurationView start,
                                                              ConfigurationView goal,
                                                              Effort& effort) const {
  ++effort.searches;
  return Query(level(index), start, goal, effort).run();
}

}  // namespace accord
