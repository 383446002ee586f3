// When a team may be at a node of its roadmap and when it may set out along an edge: what a search
// in time asks. Implementations: moving bodies, by their geometry, and constraints of nodes and
// edges. Not thread safe.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "worker/local_roadmap.h"
#include "worker/moving_obstacles.h"

namespace accord {

class TimedMotions {
 public:
  virtual ~TimedMotions() = default;

  // The times (s) at which the node is safe to be at, ascending; the last may be endless. What lies
  // before `since` (s) may be left out.
  virtual void safe_intervals(LocalRoadmap::Node node, double since,
                              std::vector<Interval>& out) = 0;
  // The earliest departure (s) within [lo, hi] along an edge from a node; nullopt: there is none.
  virtual std::optional<double> earliest_departure(LocalRoadmap::Node from,
                                                   const LocalRoadmap::Edge& edge, double lo,
                                                   double hi) = 0;
  // Whether answers cost less than it does to put the questions off.
  virtual bool are_cheap() const = 0;
  // Geometric queries answered so far, which a search's budget counts.
  virtual std::uint64_t checks() const = 0;
};

}  // namespace accord
