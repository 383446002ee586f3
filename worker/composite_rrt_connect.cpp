#include "worker/composite_rrt_connect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "worker/composite_space.h"
#include "worker/local_roadmap.h"
#include "worker/path_shortening.h"
#include "worker/safe_interval_search.h"
#include "worker/uncoupling.h"

namespace accord {
namespace {

// A tree grows by at most this share of the space's extent at a time.
constexpr double kStep = 0.15;
// Ways between the ends that are looked for, where outsiders block what was found.
constexpr std::size_t kMostWays = 6;
// Motions that a tree may try, for each node that a composite roadmap may have: a tree is sparser.
constexpr std::size_t kTriesPerNode = 4;

// A tree of joint configurations; the root is the first.
class Tree {
 public:
  explicit Tree(ConfigurationView root) : dof_(root.size()) { add(root, 0); }

  std::size_t size() const { return parents_.size(); }
  ConfigurationView at(std::size_t node) const {
    return {configurations_.data() + node * dof_, dof_};
  }
  std::size_t add(ConfigurationView q, std::size_t parent) {
    configurations_.insert(configurations_.end(), q.begin(), q.end());
    parents_.push_back(parent);
    return parents_.size() - 1;
  }
  std::size_t nearest(const Team& team, ConfigurationView q) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t node = 0; node < size(); ++node) {
      const double squared = team.squared_distance(at(node), q);
      if (squared < least) {
        least = squared;
        best = node;
      }
    }
    return best;
  }
  // The configurations from a node to the root.
  std::vector<Configuration> branch(std::size_t node) const {
    std::vector<Configuration> out;
    for (;; node = parents_[node]) {
      out.emplace_back(at(node).begin(), at(node).end());
      if (node == 0) return out;
    }
  }

 private:
  std::size_t dof_;
  std::vector<double> configurations_;  // row by row
  std::vector<std::size_t> parents_;
};

class RrtConnect {
 public:
  RrtConnect(const Workspace& workspace, const Subproblem& subproblem)
      : world_(workspace.world()),
        subproblem_(subproblem),
        team_(world_, members(subproblem), subproblem.from),
        step_(kStep * extent()),
        sampler_(workspace, subproblem) {
    team_.avoid_outsiders(subproblem);
  }

  Resolution solve(const std::atomic<bool>& stop) {
    Resolution resolution;
    const Configuration start = joint_start(subproblem_), goal = joint_goal(subproblem_);
    if (!team_.is_free(start) || !team_.is_free(goal)) return resolution;
    budget_ = kTriesPerNode * subproblem_.composite_nodes();
    const std::size_t ways = subproblem_.outsiders.empty() ? 1 : kMostWays;
    for (std::size_t way = 0; way < ways && !resolution.solved && !stop; ++way) {
      const std::vector<Configuration> places = connect(start, goal, stop);
      if (places.empty()) break;
      time(places, resolution, stop);
    }
    resolution.effort.samples = samples_;
    resolution.effort.motion_checks += motion_checks_;
    if (resolution.solved) uncouple(world_, subproblem_, resolution, stop);
    return resolution;
  }

 private:
  // The diagonal of the joint region, in the metric.
  double extent() {
    Configuration lower, upper;
    for (const Task& task : subproblem_.tasks) {
      lower.insert(lower.end(), task.region.lower.begin(), task.region.lower.end());
      upper.insert(upper.end(), task.region.upper.begin(), task.region.upper.end());
    }
    return std::sqrt(team_.squared_distance(lower, upper));
  }

  // A way from start to goal; empty when the budget runs out.
  std::vector<Configuration> connect(const Configuration& start, const Configuration& goal,
                                     const std::atomic<bool>& stop) {
    std::array<Tree, 2> trees{Tree(start), Tree(goal)};
    if (reach(trees[0], 0, goal)) return {start, goal};
    Configuration q(team_.dof());
    for (std::size_t turn = 0; motion_checks_ < budget_ && !stop; turn = 1 - turn) {
      ++samples_;
      if (!sampler_.sample_free(team_, q)) break;
      const std::size_t before = trees[turn].size();
      extend(trees[turn], trees[turn].nearest(team_, q), q);
      if (trees[turn].size() == before) continue;
      const ConfigurationView newest = trees[turn].at(before);
      const Configuration tip(newest.begin(), newest.end());
      Tree& other = trees[1 - turn];
      std::size_t node = other.nearest(team_, tip);
      while (motion_checks_ < budget_) {
        const std::size_t size = other.size();
        if (extend(other, node, tip)) return joined(trees);
        if (other.size() == size) break;
        node = size;
      }
    }
    return {};
  }

  // Ends of both trees are the same place: the way through them, from the start on.
  std::vector<Configuration> joined(const std::array<Tree, 2>& trees) const {
    std::vector<Configuration> way = trees[0].branch(trees[0].size() - 1);
    std::ranges::reverse(way);
    const std::vector<Configuration> rest = trees[1].branch(trees[1].size() - 1);
    way.insert(way.end(), rest.begin() + 1, rest.end());
    return way;
  }

  // Whether the straight motion from a node reaches q, which is added then.
  bool reach(Tree& tree, std::size_t node, ConfigurationView q) {
    ++motion_checks_;
    target_.resize(q.size());
    team_.nearest_representation(tree.at(node), q, target_);
    if (!team_.motion_is_free(tree.at(node), target_)) return false;
    tree.add(q, node);
    return true;
  }

  // Grows the tree from a node towards q by at most a step. True when q itself was reached.
  bool extend(Tree& tree, std::size_t node, ConfigurationView q) {
    const double distance = std::sqrt(team_.squared_distance(tree.at(node), q));
    if (distance <= step_) return reach(tree, node, q);
    towards_.resize(q.size());
    team_.nearest_representation(tree.at(node), q, towards_);
    for (std::size_t k = 0; k < q.size(); ++k) {
      towards_[k] = tree.at(node)[k] + step_ / distance * (towards_[k] - tree.at(node)[k]);
    }
    reach(tree, node, towards_);
    return false;
  }

  // Times the way among the outsiders; solves the resolution where that can be done.
  void time(const std::vector<Configuration>& places, Resolution& resolution,
            const std::atomic<bool>& stop) {
    LocalRoadmap roadmap(team_);
    for (const Configuration& place : places) roadmap.add(team_, place, false);
    const auto last = static_cast<LocalRoadmap::Node>(places.size() - 1);
    for (LocalRoadmap::Node node = 0; node < last; ++node) {
      roadmap.connect(team_, node, node + 1, true);
      if (node + 2 <= last) roadmap.connect(team_, node, node + 2);
    }
    const SearchRequest request = joint_request(subproblem_, 0, last);
    ++resolution.effort.searches;
    auto found = safe_interval_search(team_, roadmap, request, stop, resolution.effort.expansions);
    resolution.effort.motion_checks += roadmap.motion_checks();
    if (!found) return;
    shorten(team_, request, *found, stop, resolution.effort);
    set_joint_path(team_, *found, resolution);
  }

  const CollisionWorld& world_;
  const Subproblem& subproblem_;
  Team team_;
  double step_;
  JointSampler sampler_;
  std::size_t budget_ = 0;         // motion checks of all trees
  std::size_t motion_checks_ = 0;  // of the trees
  std::uint64_t samples_ = 0;
  Configuration target_, towards_;  // scratch
};

}  // namespace

Resolution CompositeRrtConnect::do_solve(const Workspace& workspace, const Subproblem& subproblem,
                                         const std::atomic<bool>& stop) const {
  Resolution resolution = RrtConnect(workspace, subproblem).solve(stop);
  resolution.solver = kName;
  return resolution;
}

}  // namespace accord
