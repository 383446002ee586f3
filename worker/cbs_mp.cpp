#include "worker/cbs_mp.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <queue>

#include "common/planning/conflict.h"
#include "worker/constraints.h"
#include "worker/safe_interval_search.h"
#include "worker/sparse_roadmaps.h"

namespace accord {
namespace {

// Samples that every roadmap gets when they hold no solution.
constexpr std::size_t kMoreSamples = 100;
constexpr double kForGood = std::numeric_limits<double>::infinity();
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// Robots by their place among the tasks.
struct Clash {
  std::size_t first;
  std::size_t second;
  double time;  // s
};

// What a node of the constraint tree adds to its parent's constraints.
struct Addition {
  std::size_t parent;  // index, kNone at the root
  std::size_t robot;   // whom it is for
  Constraint constraint;
};

// A node of the constraint tree that is open: the paths under all constraints up to the root.
struct Choice {
  std::size_t last = kNone;                             // index of its addition
  std::vector<std::shared_ptr<const TimedPath>> paths;  // by task
  std::vector<Clash> clashes;                           // the earliest of each pair
  double cost = 0;                                      // s: sum of arrivals
  std::size_t id = 0;                                   // order of creation
};

using ChoicePtr = std::shared_ptr<const Choice>;

struct Costlier {
  bool operator()(const ChoicePtr& a, const ChoicePtr& b) const {
    if (a->cost != b->cost) return a->cost > b->cost;
    if (a->clashes.size() != b->clashes.size()) return a->clashes.size() > b->clashes.size();
    return a->id > b->id;
  }
};

class ConstraintTree {
 public:
  ConstraintTree(const Workspace& workspace, const Subproblem& subproblem, SparseRoadmaps& roadmaps,
                 const std::atomic<bool>& stop, Effort& effort)
      : world_(workspace.world()),
        subproblem_(subproblem),
        roadmaps_(roadmaps),
        stop_(stop),
        effort_(effort) {}

  // The best paths on the roadmaps as they are; nullptr: they hold none, or stopped.
  ChoicePtr solve() {
    if (!open_root()) return nullptr;
    while (!open_.empty() && !stop_) {
      ChoicePtr choice = open_.top();
      open_.pop();
      if (choice->clashes.empty()) return choice;
      const Clash clash = *std::ranges::min_element(choice->clashes, {}, &Clash::time);
      branch(choice, clash.first, clash.second, clash.time);
      branch(choice, clash.second, clash.first, clash.time);
    }
    return nullptr;
  }

 private:
  bool open_root() {
    auto root = std::make_shared<Choice>();
    for (std::size_t i = 0; i < subproblem_.tasks.size(); ++i) {
      Constraints none(subproblem_.from);
      root->paths.push_back(search(i, none));
      if (!root->paths.back()) return false;
    }
    for (std::size_t i = 0; i < root->paths.size(); ++i) find_clashes(i, i, *root);
    open(std::move(root));
    return true;
  }

  void open(std::shared_ptr<Choice> choice) {
    choice->id = opened_++;
    for (const auto& path : choice->paths) choice->cost += path->path.end_time();
    open_.push(std::move(choice));
  }

  // The choice in which `robot` gives way to `other`.
  void branch(const ChoicePtr& parent, std::size_t robot, std::size_t other, double time) {
    if (stop_) return;
    const std::size_t last = additions_.size();
    additions_.push_back(
        {parent->last, robot,
         constraint(robot, *parent->paths[robot], other, *parent->paths[other], time)});
    Constraints constraints(subproblem_.from);
    for (std::size_t i = last; i != kNone; i = additions_[i].parent) {
      if (additions_[i].robot == robot) constraints.add(additions_[i].constraint);
    }
    auto child = std::make_shared<Choice>();
    child->last = last;
    child->paths = parent->paths;
    child->paths[robot] = search(robot, constraints);
    if (!child->paths[robot]) return;
    for (const Clash& clash : parent->clashes) {
      if (clash.first != robot && clash.second != robot) child->clashes.push_back(clash);
    }
    find_clashes(robot, child->paths.size(), *child);
    open(std::move(child));
  }

  std::shared_ptr<const TimedPath> search(std::size_t i, Constraints& constraints) {
    const Team team(world_, {subproblem_.tasks[i].robot}, subproblem_.from);
    LocalRoadmap& roadmap = roadmaps_.of(i);
    const SearchRequest request{SparseRoadmaps::kStart,
                                SparseRoadmaps::kGoal,
                                subproblem_.from,
                                kForGood,
                                subproblem_.limits.query_expansions,
                                subproblem_.limits.query_checks};
    ++effort_.searches;
    auto found = search_in_time(team, roadmap, constraints, request, stop_, effort_.expansions);
    return found ? std::make_shared<const TimedPath>(*std::move(found)) : nullptr;
  }

  // Adds the clashes of a robot with all before `end` but itself.
  void find_clashes(std::size_t robot, std::size_t end, Choice& choice) const {
    for (std::size_t other = 0; other < end; ++other) {
      if (other == robot) continue;
      const auto time = earliest_contact(world_, id(robot), choice.paths[robot]->path, id(other),
                                         choice.paths[other]->path, subproblem_.from, kForGood);
      if (time) choice.clashes.push_back({robot, other, *time});
    }
  }

  // What `robot` must not do, so that it does not run into what `other` is doing at that time.
  Constraint constraint(std::size_t robot, const TimedPath& mine, std::size_t other,
                        const TimedPath& theirs, double time) const {
    // Rounding at the ends of motions must not leave a constraint that forbids nothing.
    const double least = world_.scene().timestep;
    MovingObstacles obstacles(world_, id(robot), subproblem_.from);
    avoid_motion(id(other), theirs, time, obstacles);
    const std::size_t k = mine.path.segment_at(time);
    const bool stays = k + 1 == mine.path.size() || mine.nodes[k] == mine.nodes[k + 1];
    if (stays) return {mine.nodes[k], mine.nodes[k], unsafe_around(mine, k, time, obstacles)};
    const double t0 = mine.path.time(k), duration = mine.path.time(k + 1) - t0;
    const auto later = obstacles.earliest_departure(
        mine.path.configuration(k), mine.path.configuration(k + 1), duration, t0, kForGood);
    const double until = later ? std::max(*later, t0 + least) : kForGood;
    return {mine.nodes[k], mine.nodes[k + 1], {t0, until}};
  }

  // The other's motion, or rest, at that time.
  void avoid_motion(RobotId other, const TimedPath& theirs, double time,
                    MovingObstacles& obstacles) const {
    const Trajectory& path = theirs.path;
    const std::size_t k = path.segment_at(time);
    Trajectory motion(path.dof());
    motion.append(path.time(k), path.configuration(k));
    double until = kForGood;
    if (k + 1 < path.size()) {
      until = path.time(k + 1);
      motion.append(until, path.configuration(k + 1));
    }
    obstacles.add(other, motion, until);
  }

  Interval unsafe_around(const TimedPath& mine, std::size_t k, double time,
                         MovingObstacles& obstacles) const {
    std::vector<Interval> safe;
    obstacles.safe_intervals(mine.path.configuration(k), mine.path.start_time(), std::nullopt,
                             safe);
    Interval unsafe{subproblem_.from, kForGood};
    for (const Interval& interval : safe) {
      if (interval.hi <= time) unsafe.lo = std::max(unsafe.lo, interval.hi);
      if (interval.lo >= time) unsafe.hi = std::min(unsafe.hi, interval.lo);
    }
    unsafe.lo = std::min(unsafe.lo, time);
    unsafe.hi = std::max(unsafe.hi, time + world_.scene().timestep);
    return unsafe;
  }

  RobotId id(std::size_t task) const { return subproblem_.tasks[task].robot; }

  const CollisionWorld& world_;
  const Subproblem& subproblem_;
  SparseRoadmaps& roadmaps_;
  const std::atomic<bool>& stop_;
  Effort& effort_;
  std::priority_queue<ChoicePtr, std::vector<ChoicePtr>, Costlier> open_;
  std::vector<Addition> additions_;
  std::size_t opened_ = 0;
};

}  // namespace

Resolution CbsMp::do_solve(const Workspace& workspace, const Subproblem& subproblem,
                           const std::atomic<bool>& stop) const {
  Resolution resolution;
  resolution.solver = kName;
  for (std::size_t samples = kMoreSamples; !stop; samples += kMoreSamples) {
    if (samples > subproblem.limits.decoupled_samples) break;
    SparseRoadmaps roadmaps(workspace.world(), subproblem, samples);
    const ChoicePtr best =
        ConstraintTree(workspace, subproblem, roadmaps, stop, resolution.effort).solve();
    resolution.effort.samples += samples * subproblem.tasks.size();
    resolution.effort.motion_checks += roadmaps.motion_checks();
    if (!best) continue;
    resolution.solved = true;
    resolution.end = subproblem.from;
    for (const auto& path : best->paths) {
      resolution.end = std::max(resolution.end, path->path.end_time());
      resolution.paths.push_back(path->path);
    }
    break;
  }
  return resolution;
}

}  // namespace accord
