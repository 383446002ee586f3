#include "worker/safe_interval_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "common/planning/splice.h"
#include "worker/among_bodies.h"
#include "worker/node_table.h"
#include "worker/timed_search_states.h"
#include "worker/times_to_goal.h"

namespace accord {
namespace {

using namespace timed_search;

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
        to_goal_(team, roadmap, request.goal, request.start),
        target_(team.dof()) {}

  std::optional<TimedPath> run(std::uint64_t& expanded) {
    if (!find_goal_times()) return std::nullopt;
    open_start();
    if (const auto goal = go_straight()) return trace(*goal);
    for (std::size_t budget = request_.expansions; budget > 0 && !open_.empty() && !is_spent();) {
      const Open next = open_.top();
      open_.pop();
      if (next.left > states_[next.state].arrival) continue;  // reached earlier since
      switch (next.step) {
        case Open::Step::kLeave:
          if (is_goal(states_[next.state])) return trace(next.state);
          ++expanded;
          --budget;
          leave(next.state);
          break;
        case Open::Step::kWay:
          find_way(next);
          break;
        case Open::Step::kEnter:
          enter(next);
          break;
        case Open::Step::kDepart:
          depart(next.state, ways_[next.way].edge, next.into);
          break;
      }
    }
    return std::nullopt;
  }

 private:
  // When the goal is free for good: nobody has to be there before. False: never.
  bool find_goal_times() {
    const auto [first, count, _] = states_of(request_.goal);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Interval& interval = states_[first + i].interval;
      if (interval.hi < request_.hold_until) continue;
      goal_from_ = interval.lo;
      return true;
    }
    return false;
  }

  double bound(double arrival, double to_go) const {
    return std::max(arrival + request_.greed * to_go, goal_from_);
  }

  void open(std::uint32_t id) {
    const State& state = states_[id];
    const double to_go = to_goal_.from(state.node);
    if (std::isinf(to_go)) return;
    open_.push(
        {bound(state.arrival, to_go), to_go, state.arrival, id, kNone, kNone, Open::Step::kLeave});
  }

  void open_start() {
    const auto [first, count, _] = states_of(request_.start);
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

  // The motion from the start to the goal, if the roadmap has it and it can depart at once: nothing
  // arrives sooner. The goal's state.
  std::optional<std::uint32_t> go_straight() {
    if (open_.empty()) return std::nullopt;
    const std::uint32_t start = open_.top().state;
    const auto edges = roadmap_.edges(request_.start);
    const auto edge = std::ranges::find(edges, request_.goal, &LocalRoadmap::Edge::to);
    if (edge == edges.end() || request_.from + edge->duration < goal_from_) return std::nullopt;
    const auto [first, count, _] = states_of(request_.goal);
    for (std::uint32_t id = first; id < first + count; ++id) {
      depart(start, *edge, id);
      if (states_[id].arrival == request_.from + edge->duration && is_goal(states_[id])) return id;
    }
    return std::nullopt;
  }

  bool is_goal(const State& state) const {
    return state.node == request_.goal &&
           state.interval.hi >= std::max(state.arrival, request_.hold_until);
  }

  NodeStates states_of(Node node) {
    NodeStates& known = of_node_[node];
    if (known.first == kNone) {
      motions_.safe_intervals(node, soonest_at(node), intervals_);
      known.first = static_cast<std::uint32_t>(states_.size());
      known.count = static_cast<std::uint32_t>(intervals_.size());
      for (const Interval& interval : intervals_) states_.push_back({node, interval});
    }
    return known;
  }

  bool is_spent() const { return stop_ || motions_.checks() > checks_end_; }

  // Nothing gets there earlier (s).
  double soonest_at(Node node) {
    const ConfigurationView start = roadmap_.configuration(request_.start);
    team_.nearest_representation(start, roadmap_.configuration(node), target_);
    return request_.from + team_.duration(start, target_) - MovingObstacles::kSlack;
  }

  double crow_flies(Node node) {
    double& to_go = of_node_[node].to_go;
    if (to_go < 0) {
      const ConfigurationView q = roadmap_.configuration(node);
      team_.nearest_representation(q, roadmap_.configuration(request_.goal), target_);
      to_go = team_.duration(q, target_);
    }
    return to_go;
  }

  void leave(std::uint32_t id) {
    if (motions_.are_cheap()) {
      leave_at_once(id);
    } else {
      open_ways(id);
    }
  }

  // Along every edge, nothing put off.
  void leave_at_once(std::uint32_t id) {
    for (const LocalRoadmap::Edge& edge : roadmap_.edges(states_[id].node)) {
      if (is_spent()) return;
      const auto [first, count, _] = states_of(edge.to);
      for (std::uint32_t i = 0; i < count; ++i) depart(id, edge, first + i);
    }
  }

  void open_ways(std::uint32_t id) {
    const State& from = states_[id];
    const auto begin = ways_.size();
    for (const LocalRoadmap::Edge& edge : roadmap_.edges(from.node)) {
      if (was_reached_by(from.arrival + edge.duration, edge.to)) continue;
      const double to_go = crow_flies(edge.to);
      ways_.push_back({bound(from.arrival + edge.duration, to_go), to_go, edge, false});
    }
    if (begin == ways_.size()) return;
    std::sort(ways_.begin() + static_cast<std::ptrdiff_t>(begin), ways_.end(),
              [](const Way& a, const Way& b) {
                return std::tie(a.bound, a.to_go, a.edge.id) <
                       std::tie(b.bound, b.to_go, b.edge.id);
              });
    ways_.back().is_last = true;
    open_way(id, static_cast<std::uint32_t>(begin));
  }

  // Whether a node that is safe for all time has been reached by then.
  bool was_reached_by(double arrival, Node node) {
    const NodeStates& known = of_node_[node];
    return known.first != kNone && known.count == 1 && states_[known.first].arrival <= arrival;
  }

  void open_way(std::uint32_t id, std::uint32_t way) {
    open_.push({ways_[way].bound, ways_[way].to_go, states_[id].arrival, id, way, kNone,
                Open::Step::kWay});
  }

  // Whether it would be taken out of the queue as soon as it is put in.
  bool is_next(const Open& motion) const { return open_.empty() || !(motion < open_.top()); }

  void find_way(Open motion) {
    const Way way = ways_[motion.way];
    if (!way.is_last) open_way(motion.state, motion.way + 1);
    motion.to_go = to_goal_.from(way.edge.to);
    if (std::isinf(motion.to_go)) return;
    motion.bound = bound(states_[motion.state].arrival + way.edge.duration, motion.to_go);
    motion.step = Open::Step::kEnter;
    if (is_next(motion)) {
      enter(motion);
    } else {
      open_.push(motion);
    }
  }

  void enter(Open motion) {
    const LocalRoadmap::Edge edge = ways_[motion.way].edge;
    const auto [first, count, _] = states_of(edge.to);
    const State& from = states_[motion.state];
    for (std::uint32_t id = first; id < first + count; ++id) {
      const State& to = states_[id];
      const double arrival = std::max(from.arrival + edge.duration, to.interval.lo);
      if (arrival - edge.duration > from.interval.hi || arrival > to.interval.hi) continue;
      if (arrival >= to.arrival) continue;
      motion.bound = bound(arrival, motion.to_go);
      motion.into = id;
      motion.step = Open::Step::kDepart;
      if (count == 1 && is_next(motion)) return depart(motion.state, edge, id);
      open_.push(motion);
    }
  }

  void depart(std::uint32_t from_id, const LocalRoadmap::Edge& edge, std::uint32_t to_id) {
    const State& from = states_[from_id];
    State& to = states_[to_id];
    const double lo = std::max(from.arrival, to.interval.lo - edge.duration);
    const double hi = std::min(from.interval.hi, to.interval.hi - edge.duration);
    if (lo > hi || lo + edge.duration >= to.arrival) return;
    if (!roadmap_.is_free(team_, from.node, edge)) return;
    const auto departure = motions_.earliest_departure(from.node, edge, lo, hi);
    if (!departure || *departure + edge.duration >= to.arrival) return;
    to.arrival = *departure + edge.duration;
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
  std::vector<Way> ways_;
  std::priority_queue<Open> open_;
  std::vector<Interval> intervals_;  // scratch
  Configuration target_;             // scratch
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
