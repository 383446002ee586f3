#include "worker/composite_prm.h"

#include <algorithm>
#include <optional>

#include "worker/composite_space.h"
#include "worker/local_roadmap.h"
#include "worker/path_shortening.h"
#include "worker/roadmap_evolution.h"
#include "worker/safe_interval_search.h"
#include "worker/uncoupling.h"

namespace accord {
namespace {

constexpr LocalRoadmap::Node kStart = 0;
constexpr LocalRoadmap::Node kGoal = 1;
constexpr std::size_t kNeighbours = 12;
constexpr std::size_t kTriesPerNode = 160;

class CompositeRoadmap {
 public:
  CompositeRoadmap(const Workspace& workspace, const Subproblem& subproblem)
      : subproblem_(subproblem),
        team_(workspace.world(), members(subproblem), subproblem.from),
        sampler_(workspace, subproblem),
        roadmap_(team_),
        evolution_(subproblem.limits.composite_window_per_dof * team_.dof()) {
    team_.avoid_outsiders(subproblem);
  }

  Resolution solve(const CollisionWorld& world, const std::atomic<bool>& stop) {
    Resolution resolution;
    if (add_ends()) grow(resolution, stop);
    resolution.effort.samples = roadmap_.size();
    resolution.effort.motion_checks += motion_checks_ + roadmap_.motion_checks();
    if (resolution.solved) uncouple(world, subproblem_, resolution, stop);
    return resolution;
  }

 private:
  bool add_ends() {
    const Configuration start = joint_start(subproblem_), goal = joint_goal(subproblem_);
    if (!team_.is_free(start) || !team_.is_free(goal)) return false;
    insert(start);
    insert(goal);
    return true;
  }

  void grow(Resolution& resolution, const std::atomic<bool>& stop) {
    const std::size_t limit = subproblem_.composite_nodes();
    std::size_t search_at = 0;
    Configuration q(team_.dof());
    while (!stop) {
      if (evolution_.connected(kStart, kGoal) && roadmap_.size() >= search_at) {
        if (search(resolution, stop)) return;
        search_at = roadmap_.size() + roadmap_.size() / 4 + 8;
      }
      // Where nothing is left to grow the search goes on, productive or not.
      if (roadmap_.size() >= limit || (!subproblem_.is_last() && evolution_.has_settled())) return;
      if (!sample(q, stop)) return;
      insert(q);
    }
  }

  bool search(Resolution& resolution, const std::atomic<bool>& stop) {
    const SearchRequest request = joint_request(subproblem_, kStart, kGoal);
    ++resolution.effort.searches;
    auto found = safe_interval_search(team_, roadmap_, request, stop, resolution.effort.expansions);
    if (!found) return false;
    shorten(team_, request, *found, stop, resolution.effort);
    set_joint_path(team_, *found, resolution);
    return true;
  }

  // A free joint configuration.
  bool sample(Configuration& q, const std::atomic<bool>& stop) {
    for (std::size_t tries = 0; tries < kTriesPerNode && !stop; ++tries) {
      // Where nothing is left to grow, every other one next to one that is known.
      if (subproblem_.is_last() && (roadmap_.size() + tries) % 2 == 1) {
        const auto node = static_cast<LocalRoadmap::Node>(sampler_.below(roadmap_.size()));
        std::ranges::copy(roadmap_.configuration(node), q.begin());
        if (sampler_.move_one(team_, q)) return true;
      } else if (sampler_.sample_free(team_, q)) {
        return true;
      }
    }
    return false;
  }

  // Adds a node and proves motions to its neighbours in other components, nearest first; within its
  // own component edges are laid unproved, for the search to prove where it needs them.
  void insert(ConfigurationView q) {
    const LocalRoadmap::Node node = roadmap_.add(team_, q, false);
    evolution_.add(q);
    roadmap_.nearest(team_, q, kNeighbours, node, neighbours_);
    std::size_t joined = 0;
    bool any_failed = false, grew = false;
    target_.resize(team_.dof());
    for (const LocalRoadmap::Node neighbour : neighbours_) {
      const bool other_component = !evolution_.connected(node, neighbour);
      if (other_component) {
        ++motion_checks_;
        team_.nearest_representation(q, roadmap_.configuration(neighbour), target_);
        if (!team_.motion_is_free(q, target_)) {
          any_failed = true;
          continue;
        }
        const double before = evolution_.diameter(neighbour);
        evolution_.join(node, neighbour);
        grew = grew || evolution_.diameter(node) > before;
        ++joined;
      }
      roadmap_.connect(team_, node, neighbour, other_component);
    }
    evolution_.classify(joined, any_failed, grew);
  }

  const Subproblem& subproblem_;
  Team team_;
  JointSampler sampler_;
  LocalRoadmap roadmap_;
  RoadmapEvolution evolution_;
  std::uint64_t motion_checks_ = 0;
  std::vector<LocalRoadmap::Node> neighbours_;  // scratch
  Configuration target_;                        // scratch
};

}  // namespace

Resolution CompositePrm::do_solve(const Workspace& workspace, const Subproblem& subproblem,
                                  const std::atomic<bool>& stop) const {
  Resolution resolution = CompositeRoadmap(workspace, subproblem).solve(workspace.world(), stop);
  resolution.solver = kName;
  return resolution;
}

}  // namespace accord
