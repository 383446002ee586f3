#include "worker/safe_interval_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "common/planning/splice.h"
#include "worker/node_table.h"
#include "worker/times_to_goal.h"

namespace accord {
namespace {

using Node = LocalRoadmap::Node;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A node within one of its safe intervals.
struct State {
  Node node;
  Interval interval;
  double arrival = std::numeric_limits<double>::infinity();
  double departure = 0;  // from the parent
  std::uint32_t parent = kNone;
};

// Which states are those of a node.
struct NodeStates {
  std::uint32_t first = kNone;  // kNone: not known yet
  std::uint32_t count = 0;
};

struct Open {
  double bound;    // on the arrival at the goal
  double to_go;    // least time from here to the goal
  double arrival;  // here; what it was when this was put into the queue
  std::uint32_t state;

  // For a queue with the least bound on top; of equals the one nearest to the goal.
  bool operator<(const Open& other) const {
    if (bound != other.bound) return bound > other.bound;
    if (to_go != other.to_go) return to_go > other.to_go;
    return state > other.state;
  }
};

// Among the moving bodies that a team avoids.
class AmongBodies final : public TimedMotions {
 public:
  AmongBodies(Team& team, const LocalRoadmap& roadmap)
      : team_(team), roadmap_(roadmap), target_(team.dof()) {}

  void safe_intervals(Node node, std::vector<Interval>& out) override {
    team_.safe_intervals(roadmap_.configuration(node), out);
  }
  std::optional<double> earliest_departure(Node from, const LocalRoadmap::Edge& edge, double lo,
                                           double hi) override {
    const ConfigurationView q = roadmap_.configuration(from);
    team_.nearest_representation(q, roadmap_.configuration(edge.to), target_);
    return team_.earliest_departure(q, target_, edge.duration, lo, hi);
  }
  std::uint64_t checks() const override { return team_.checks(); }

 private:
  Team& team_;
  const LocalRoadmap& roadmap_;
  Configuration target_;  // scratch
};

class Search {
 public:
  Search(const Team& team, LocalRoadmap& roadmap, TimedMotions& motions,
         const SearchRequest& request, const std::atomic<bool>& stop)
      : team_(team),
        roadmap_(roadmap),
        motions_(motions),
        request_(request),
        stop_(stop),
        checks_end_(motions.checks() + request.checks),
        of_node_(roadmap.size()),
        to_goal_(team, roadmap, request.goal, request.start) {}

  std::optional<TimedPath> run(std::uint64_t& expanded) {
    if (!find_goal_times()) return std::nullopt;
    open_start();
    for (std::size_t budget = request_.expansions; budget > 0 && !open_.empty() && !is_spent();) {
      const auto [bound, to_go, arrival, id] = open_.top();
      open_.pop();
      if (arrival > states_[id].arrival) continue;  // reached earlier since
      if (is_goal(states_[id])) return trace(id);
      ++expanded;
      --budget;
      expand(id);
    }
    return std::nullopt;
  }

 private:
  // When the goal is free for good: nobody has to be there before. False: never.
  bool find_goal_times() {
    const auto [first, count] = states_of(request_.goal);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Interval& interval = states_[first + i].interval;
      if (interval.hi < request_.hold_until) continue;
      goal_from_ = interval.lo;
      return true;
    }
    return false;
  }

  void open(std::uint32_t id) {
    const State& state = states_[id];
    const double to_go = to_goal_.from(state.node);
    if (std::isinf(to_go)) return;
    const double bound = state.arrival + request_.greed * to_go;
    open_.push({std::max(bound, goal_from_), to_go, state.arrival, id});
  }

  void open_start() {
    const auto [first, count] = states_of(request_.start);
    for (std::uint32_t i = 0; i < count; ++i) {
      State& state = states_[first + i];
      // The start is where the robot is: it may lie in the slack of what it is passing just now.
      constexpr double kLeeway = 2 * MovingObstacles::kSlack;
      if (state.interval.lo > request_.from + kLeeway) continue;
      if (state.interval.hi < request_.from - kLeeway) continue;
      state.interval.hi = std::max(state.interval.hi, request_.from);
      state.arrival = request_.from;
      open(first + i);
    }
  }

  bool is_goal(const State& state) const {
    return state.node == request_.goal &&
           state.interval.hi >= std::max(state.arrival, request_.hold_until);
  }

  NodeStates states_of(Node node) {
    NodeStates& known = of_node_[node];
    if (known.first == kNone) {
      motions_.safe_intervals(node, intervals_);
      known = {static_cast<std::uint32_t>(states_.size()),
               static_cast<std::uint32_t>(intervals_.size())};
      for (const Interval& interval : intervals_) states_.push_back({node, interval});
    }
    return known;
  }

  bool is_spent() const { return stop_ || motions_.checks() > checks_end_; }

  void expand(std::uint32_t id) {
    for (const LocalRoadmap::Edge& edge : roadmap_.edges(states_[id].node)) {
      if (is_spent()) return;
      const auto [first, count] = states_of(edge.to);
      for (std::uint32_t i = 0; i < count; ++i) relax(id, edge, first + i);
    }
  }

  void relax(std::uint32_t from_id, const LocalRoadmap::Edge& edge, std::uint32_t to_id) {
    const State from = states_[from_id];
    const Interval there = states_[to_id].interval;
    const double lo = std::max(from.arrival, there.lo - edge.duration);
    const double hi = std::min(from.interval.hi, there.hi - edge.duration);
    if (lo > hi || lo + edge.duration >= states_[to_id].arrival) return;
    if (!roadmap_.is_free(team_, from.node, edge)) return;
    const auto departure = motions_.earliest_departure(from.node, edge, lo, hi);
    if (!departure) return;
    const double arrival = *departure + edge.duration;
    State& to = states_[to_id];
    if (arrival >= to.arrival) return;
    to.arrival = arrival;
    to.departure = *departure;
    to.parent = from_id;
    open(to_id);
  }

  TimedPath trace(std::uint32_t id) const {
    std::vector<std::uint32_t> states;
    for (std::uint32_t s = id; s != kNone; s = states_[s].parent) states.push_back(s);
    std::ranges::reverse(states);
    Trajectory path(team_.dof());
    Configuration q(team_.dof());
    const ConfigurationView start = roadmap_.configuration(request_.start);
    std::copy(start.begin(), start.end(), q.begin());
    path.append(request_.from, q);
    std::vector<Node> nodes{request_.start};
    for (std::size_t i = 1; i < states.size(); ++i) {
      const State& state = states_[states[i]];
      // A wait of less than an instant is rounding.
      if (state.departure > path.end_time() + kSameInstant) {
        path.append(state.departure, q);
        nodes.push_back(nodes.back());
      }
      // Whole turns add up along the path: each waypoint is written nearest to the one before.
      team_.nearest_representation(path.configuration(path.size() - 1),
                                   roadmap_.configuration(state.node), q);
      append_apart(state.arrival, q, path);
      nodes.push_back(state.node);
    }
    return {std::move(path), std::move(nodes)};
  }

  const Team& team_;
  LocalRoadmap& roadmap_;
  TimedMotions& motions_;
  const SearchRequest& request_;
  const std::atomic<bool>& stop_;
  std::uint64_t checks_end_;
  NodeTable<NodeStates> of_node_;
  TimesToGoal to_goal_;
  double goal_from_ = 0;  // s
  std::vector<State> states_;
  std::priority_queue<Open> open_;
  std::vector<Interval> intervals_;  // scratch
};

}  // namespace

std::optional<TimedPath> search_in_time(const Team& team, LocalRoadmap& roadmap,
                                        TimedMotions& motions, const SearchRequest& request,
                                        const std::atomic<bool>& stop, std::uint64_t& expanded) {
  return Search(team, roadmap, motions, request, stop).run(expanded);
}

std::optional<Trajectory> safe_interval_search(Team& team, LocalRoadmap& roadmap,
                                               const SearchRequest& request,
                                               const std::atomic<bool>& stop,
                                               std::uint64_t& expanded) {
  AmongBodies motions(team, roadmap);
  auto found = search_in_time(team, roadmap, motions, request, stop, expanded);
  if (!found) return std::nullopt;
  return std::move(found->path);
}

}  // namespace accord
