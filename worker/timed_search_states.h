// What a search in time keeps of states and of what to look at next. For safe_interval_search.cpp.
#pragma once

#include <cstdint>
#include <limits>

#include "worker/interval.h"
#include "worker/local_roadmap.h"

namespace accord::timed_search {

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
  double to_go = -1;  // s: least time to the goal as the crow flies; negative: not known yet
};

// What to look at next. A motion out of a state is worked out in steps, each of which can only put
// it off: of most, the first shows that they lead nowhere soon (lazy A*; Cohen, Phillips and
// Likhachev 2014).
struct Open {
  enum class Step : std::uint8_t {
    kLeave,   // a state is reached: set out from it
    kWay,     // a motion, the best of those left: how far is it to the goal from its end?
    kEnter,   // a motion: which intervals of its end can it reach?
    kDepart,  // a motion into an interval: when can it depart?
  };

  double bound;         // on the arrival at the goal
  double to_go;         // time from here to the goal, at least
  double left;          // the arrival at `state` when this was put into the queue
  std::uint32_t state;  // of which this is, or out of which the motion leads
  std::uint32_t way;    // of the motion
  std::uint32_t into;   // kDepart: the state
  Step step;

  // For a queue with the least bound on top; of equals the one nearest to the goal.
  bool operator<(const Open& other) const {
    if (bound != other.bound) return bound > other.bound;
    if (to_go != other.to_go) return to_go > other.to_go;
    if (step != other.step) return step < other.step;
    return state > other.state;
  }
};

// A motion out of a state, as one of a run of these, best first.
struct Way {
  double bound;  // on the arrival at the goal
  double to_go;  // s, as the crow flies
  LocalRoadmap::Edge edge;
  bool is_last;  // of the run
};

}  // namespace accord::timed_search
