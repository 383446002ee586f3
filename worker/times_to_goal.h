// The least time from nodes of a roadmap to a goal, other robots left aside: what guides a search
// in time. Worked out backwards from the goal, towards where the search starts, as far as asked
// (reverse resumable A*; Silver, "Cooperative pathfinding", 2005).
// Not thread safe; the roadmap must outlive it and not grow meanwhile.
#pragma once

#include <limits>
#include <queue>

#include "worker/local_roadmap.h"
#include "worker/node_table.h"
#include "worker/team.h"

namespace accord {

class TimesToGoal {
 public:
  using Node = LocalRoadmap::Node;

  TimesToGoal(const Team& team, const LocalRoadmap& roadmap, Node goal, Node start);

  // s, along edges that were not known to be blocked when this was worked out: a lower bound.
  // Infinite where none lead to the goal.
  double from(Node node);

 private:
  struct Reached {
    double bound;  // s: on the way from the start through here
    double time;   // s: from here to the goal
    Node node;

    bool operator<(const Reached& other) const {
      return bound != other.bound ? bound > other.bound : node > other.node;
    }
  };

  struct Least {
    double time = std::numeric_limits<double>::infinity();  // s: the least found
    bool is_known = false;                                  // to be the least of all
  };

  void reach(Node node, double time);

  const Team& team_;
  const LocalRoadmap& roadmap_;
  ConfigurationView start_;
  NodeTable<Least> least_;
  std::priority_queue<Reached> open_;
  Configuration near_;  // scratch
};

}  // namespace accord
