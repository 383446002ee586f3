// What conflict-based search forbids one robot: to be at a node, or to set out along an edge,
// during some time. Not thread safe.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "worker/timed_motions.h"

namespace accord {

// Half open in effect: a robot may be there, or set out, from `hi` on.
struct Constraint {
  LocalRoadmap::Node from;
  LocalRoadmap::Node to;  // equals `from` for being at a node
  Interval when;          // s; hi may be infinite
};

class Constraints final : public TimedMotions {
 public:
  // From the instant `from` (s) on.
  explicit Constraints(double from) : from_(from) {}

  void add(const Constraint& constraint);

  void safe_intervals(LocalRoadmap::Node node, double since, std::vector<Interval>& out) override;
  std::optional<double> earliest_departure(LocalRoadmap::Node from, const LocalRoadmap::Edge& edge,
                                           double lo, double hi) override;
  bool are_cheap() const override { return true; }
  std::uint64_t checks() const override { return 0; }  // no geometry

 private:
  using Place = std::pair<LocalRoadmap::Node, LocalRoadmap::Node>;

  double from_;
  std::map<Place, std::vector<Interval>> forbidden_;  // sorted by lo
};

}  // namespace accord
