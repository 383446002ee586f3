#include "worker/prioritized_repair.h"

#include <algorithm>
#include <deque>
#include <optional>

#include "common/planning/conflict.h"
#include "worker/continuation.h"
#include "worker/path_shortening.h"
#include "worker/point_traffic.h"
#include "worker/safe_interval_search.h"

namespace accord {
namespace {

// A robot that has no path yet is left this share of the window to get away from its start.
constexpr double kAwaited = 0.125;

// Times that a robot may be asked to make way, for each order that the limits allow.
constexpr std::size_t kYieldsPerOrder = 2;

// The robots of a team: where those whose paths stand for now are going, and where the others wait
// to be planned. By task.
class Settled {
 public:
  Settled(const CollisionWorld& world, const Subproblem& subproblem, DecoupledRoadmaps& roadmaps)
      : world_(world),
        subproblem_(subproblem),
        roadmaps_(roadmaps),
        await_until_(subproblem.from + kAwaited * (std::min(subproblem.to, subproblem.clear_until) -
                                                   subproblem.from)),
        traffic_(room(world, subproblem)),
        starts_(room(world, subproblem)),
        paths_(subproblem.tasks.size()),
        onwards_(subproblem.tasks.size()),
        stands_(subproblem.tasks.size(), false) {
    for (const Outsider& outsider : subproblem.outsiders) {
      const auto radius = world.radius(outsider.robot);
      if (!radius) continue;
      for (PointTraffic* traffic : {&traffic_, &starts_}) {
        traffic->add(outsider.robot.value, outsider.path, *radius, subproblem.from, outsider.until);
      }
    }
    for (std::size_t i = 0; i < stands_.size(); ++i) add_start(i, starts_);
  }

  std::vector<Trajectory> take_paths() { return std::move(paths_); }

  void add(std::size_t i, Trajectory path) {
    onwards_[i] = with_tail(world_, subproblem_.tasks[i], path);
    paths_[i] = std::move(path);
    stands_[i] = true;
    traffic_.remove(robot(i).value);
    if (const auto radius = world_.radius(robot(i))) {
      traffic_.add(robot(i).value, onwards_[i], *radius, subproblem_.from, avoided_until(i));
    }
  }

  void remove(std::size_t i) {
    stands_[i] = false;
    await(i);
  }

  // From now on robot i is waited for at its start.
  void await(std::size_t i) {
    traffic_.remove(robot(i).value);
    add_start(i, traffic_);
  }

  // Has a team of robot i alone avoid all settled, the starts of those waited for, and outsiders.
  void avoid_all(std::size_t i, Team& team) {
    traffic_.remove(robot(i).value);
    avoid_others(i, traffic_, team);
    for (std::size_t j = 0; j < stands_.size(); ++j) {
      if (stands_[j] && j != i && !(is_point(i) && is_point(j))) avoid(i, j, team);
    }
  }

  // Has a team of robot i alone avoid the settled that `is_firm` holds for, all others' starts, and
  // outsiders.
  template <class Predicate>
  void avoid_some(std::size_t i, Team& team, const Predicate& is_firm) {
    starts_.remove(robot(i).value);
    avoid_others(i, starts_, team);
    firm_.assign(world_.scene().robots.size(), 0);
    for (std::size_t j = 0; j < stands_.size(); ++j) {
      if (!stands_[j] || j == i || !is_firm(j)) continue;
      if (is_point(i) && is_point(j)) {
        firm_[robot(j).index()] = 1;
      } else {
        avoid(i, j, team);
      }
    }
    if (is_point(i)) team.avoid(traffic_, &firm_);
  }

  // After avoid_some().
  void restore_start(std::size_t i) { add_start(i, starts_); }

  // The settled that robot i on `path` would run into before both have left the window.
  std::vector<std::size_t> touched_by(std::size_t i, const Trajectory& path) const {
    const Trajectory onwards = with_tail(world_, subproblem_.tasks[i], path);
    std::vector<std::size_t> touched;
    for (std::size_t j = 0; j < stands_.size(); ++j) {
      if (!stands_[j]) continue;
      const double until =
          std::min(subproblem_.clear_until, std::max(path.end_time(), paths_[j].end_time()));
      if (earliest_contact(world_, robot(i), onwards, robot(j), onwards_[j], subproblem_.from,
                           until)) {
        touched.push_back(j);
      }
    }
    return touched;
  }

 private:
  void add_start(std::size_t i, PointTraffic& traffic) {
    const auto radius = world_.radius(robot(i));
    if (!radius) return;
    Trajectory start(subproblem_.tasks[i].start.size());
    start.append(subproblem_.from, subproblem_.tasks[i].start);
    traffic.add(robot(i).value, start, *radius, subproblem_.from, await_until_);
  }

  // The outsiders, and for a disc or ball all of `traffic`.
  void avoid_others(std::size_t i, const PointTraffic& traffic, Team& team) {
    if (is_point(i)) team.avoid(traffic);
    for (const Outsider& outsider : subproblem_.outsiders) {
      if (is_point(i) && world_.radius(outsider.robot)) continue;
      roadmaps_.avoid(i, outsider.robot, outsider.path, outsider.until, team);
    }
  }

  void avoid(std::size_t i, std::size_t j, Team& team) {
    roadmaps_.avoid(i, robot(j), onwards_[j], avoided_until(j), team);
  }

  // For good where it has parked: waiting for it to vanish must not seem a way past it.
  double avoided_until(std::size_t i) const {
    const double until = subproblem_.clear_until;
    return onwards_[i].end_time() <= until ? std::numeric_limits<double>::infinity() : until;
  }

  bool is_point(std::size_t i) const { return world_.radius(robot(i)).has_value(); }
  RobotId robot(std::size_t i) const { return subproblem_.tasks[i].robot; }

  // The most that centres of a robot of the team and what it meets must keep, less the latter's
  // radius.
  static double room(const CollisionWorld& world, const Subproblem& subproblem) {
    double largest = 0;
    for (const Task& task : subproblem.tasks) {
      largest = std::max(largest, world.radius(task.robot).value_or(0));
    }
    constexpr double kLeast = 0.01;  // m: cells must not vanish
    return std::max(largest + world.required_separation(), kLeast);
  }

  const CollisionWorld& world_;
  const Subproblem& subproblem_;
  DecoupledRoadmaps& roadmaps_;
  double await_until_;    // s
  PointTraffic traffic_;  // discs and balls: the settled, and starts of those waited for
  PointTraffic starts_;   // and everyone's starts
  std::vector<Trajectory> paths_;
  std::vector<Trajectory> onwards_;  // with their tails
  std::vector<char> stands_;
  std::vector<char> firm_;  // by robot; what avoid_some() goes by
};

class Repair {
 public:
  Repair(const CollisionWorld& world, const Subproblem& subproblem, DecoupledRoadmaps& roadmaps,
         const std::atomic<bool>& stop, Effort& effort)
      : world_(world),
        subproblem_(subproblem),
        roadmaps_(roadmaps),
        stop_(stop),
        effort_(effort),
        settled_(world, subproblem, roadmaps),
        yielded_(subproblem.tasks.size(), 0) {}

  // Settles whom it can. Those it cannot are left().
  void run() {
    keep_what_is_clear();
    for (const std::size_t i : waiting_) settled_.await(i);
    const std::size_t robots = subproblem_.tasks.size();
    const std::uint64_t last =
        effort_.expansions + robots * subproblem_.limits.query_expansions / 4;
    for (std::size_t plans = robots * subproblem_.limits.priority_orders; !waiting_.empty();) {
      const std::size_t i = waiting_.front();
      waiting_.pop_front();
      const bool is_spent = plans == 0 || effort_.expansions > last || stop_;
      std::optional<Trajectory> path;
      if (!is_spent && !is_jammed(i)) {
        --plans;
        path = plan(i);
        if (!path) path = plan_through(i);
      }
      if (path) {
        settled_.add(i, std::move(*path));
      } else {
        left_.push_back(i);
      }
    }
  }

  // Robots that no path was found for.
  const std::vector<std::size_t>& left() const { return left_; }
  // Of the others.
  std::vector<Trajectory> take_paths() { return settled_.take_paths(); }

 private:
  // A robot that has made way so often is caught in a jam.
  bool is_jammed(std::size_t i) const {
    return yielded_[i] > kYieldsPerOrder * subproblem_.limits.priority_orders;
  }

  // Settles the robots that can go on as they do.
  void keep_what_is_clear() {
    for (std::size_t i = 0; i < subproblem_.tasks.size(); ++i) {
      if (stays_clear(i)) {
        settled_.add(i, subproblem_.tasks[i].guide);
      } else {
        waiting_.push_back(i);
      }
    }
  }

  // Whether a robot's present path is clear of the outsiders and of all settled.
  bool stays_clear(std::size_t i) {
    const Task& task = subproblem_.tasks[i];
    const Trajectory& path = task.guide;
    if (path.empty()) return false;
    Team team(world_, {task.robot}, subproblem_.from);
    settled_.avoid_all(i, team);
    for (std::size_t k = 1; k < path.size(); ++k) {
      const double t = path.time(k - 1);
      if (!team.motion_is_clear(path.configuration(k - 1), path.configuration(k), t,
                                path.time(k) - t)) {
        return false;
      }
    }
    std::vector<Interval> safe;
    team.safe_intervals(task.goal, path.end_time(), safe);
    const double hold = std::max(path.end_time(), hold_until(subproblem_, task));
    return std::ranges::any_of(safe, [&](const Interval& interval) {
      return interval.lo <= path.end_time() && interval.hi >= hold;
    });
  }

  // Around all settled.
  std::optional<Trajectory> plan(std::size_t i) {
    return plan(i, [&](Team& team) { settled_.avoid_all(i, team); });
  }

  // Around the settled that have made way at least so often.
  std::optional<Trajectory> plan_around_yielding(std::size_t i, unsigned times) {
    auto path = plan(i, [&](Team& team) {
      settled_.avoid_some(i, team, [&](std::size_t j) { return yielded_[j] >= times; });
    });
    settled_.restore_start(i);
    return path;
  }

  // Around nobody but outsiders, and these no longer than the team avoids its own: whoever has
  // parked in the only way will be asked to move when it comes to it.
  std::optional<Trajectory> plan_past_all(std::size_t i) {
    return plan(i, [&](Team& team) {
      for (const Outsider& outsider : subproblem_.outsiders) {
        team.avoid(outsider.robot, outsider.path,
                   std::min(outsider.until, subproblem_.clear_until));
      }
    });
  }

  template <class Avoid>
  std::optional<Trajectory> plan(std::size_t i, const Avoid& avoid) {
    const Task& task = subproblem_.tasks[i];
    Team team(world_, {task.robot}, subproblem_.from);
    avoid(team);
    LocalRoadmap& roadmap = roadmaps_.of(i);
    const SearchRequest request{DecoupledRoadmaps::start(roadmap),
                                DecoupledRoadmaps::goal(roadmap),
                                subproblem_.from,
                                hold_until(subproblem_, task),
                                subproblem_.limits.query_expansions,
                                subproblem_.limits.query_checks};
    ++effort_.searches;
    auto found = safe_interval_search(team, roadmap, request, stop_, effort_.expansions);
    if (found) shorten(team, request, *found, stop_, effort_);
    return found;
  }

  // Through settled robots, which are left waiting. Those that have made way before are asked last:
  // else the same few would push each other around for ever.
  std::optional<Trajectory> plan_through(std::size_t i) {
    const unsigned most = *std::ranges::max_element(yielded_);
    std::optional<Trajectory> path;
    for (unsigned times = 1; !path && times < 2 * most + 2; times *= 2) {
      path = plan_around_yielding(i, times);
    }
    if (!path) path = plan_past_all(i);
    if (!path) return path;
    for (const std::size_t j : settled_.touched_by(i, *path)) {
      settled_.remove(j);
      ++yielded_[j];
      waiting_.push_back(j);
    }
    return path;
  }

  const CollisionWorld& world_;
  const Subproblem& subproblem_;
  DecoupledRoadmaps& roadmaps_;
  const std::atomic<bool>& stop_;
  Effort& effort_;
  Settled settled_;
  std::deque<std::size_t> waiting_;
  std::vector<std::size_t> left_;
  std::vector<unsigned> yielded_;  // by task: how often it has made way for another
};

}  // namespace

Resolution prioritized_repair(const CollisionWorld& world, const Subproblem& subproblem,
                              DecoupledRoadmaps& roadmaps, const std::atomic<bool>& stop,
                              Effort& effort) {
  Resolution out;
  Repair repair(world, subproblem, roadmaps, stop, effort);
  repair.run();
  out.solved = repair.left().empty();
  if (!out.solved && (!subproblem.is_crowd() || stop)) return out;
  out.end = subproblem.from;
  out.paths = repair.take_paths();
  for (const std::size_t i : repair.left()) {
    out.left.push_back(subproblem.tasks[i].robot);
    out.paths[i] = subproblem.tasks[i].guide;
  }
  for (const Trajectory& path : out.paths) out.end = std::max(out.end, path.end_time());
  return out;
}

}  // namespace accord
