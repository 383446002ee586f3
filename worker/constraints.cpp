#include "worker/constraints.h"

#include <algorithm>
#include <limits>

namespace accord {

void Constraints::add(const Constraint& constraint) {
  std::vector<Interval>& mine = forbidden_[{constraint.from, constraint.to}];
  const auto later = std::ranges::upper_bound(mine, constraint.when.lo, {}, &Interval::lo);
  mine.insert(later, constraint.when);
}

void Constraints::safe_intervals(LocalRoadmap::Node node, double, std::vector<Interval>& out) {
  out.clear();
  double safe_from = from_;
  const auto found = forbidden_.find({node, node});
  if (found != forbidden_.end()) {
    for (const Interval& unsafe : found->second) {
      if (unsafe.lo > safe_from) out.push_back({safe_from, unsafe.lo});
      safe_from = std::max(safe_from, unsafe.hi);
    }
  }
  constexpr double kForGood = std::numeric_limits<double>::infinity();
  if (safe_from < kForGood) out.push_back({safe_from, kForGood});
}

std::optional<double> Constraints::earliest_departure(LocalRoadmap::Node from,
                                                      const LocalRoadmap::Edge& edge, double lo,
                                                      double hi) {
  const auto found = forbidden_.find({from, edge.to});
  if (found != forbidden_.end()) {
    for (const Interval& unsafe : found->second) {
      if (lo >= unsafe.lo && lo < unsafe.hi) lo = unsafe.hi;
    }
  }
  if (lo > hi) return std::nullopt;
  return lo;
}

}  // namespace accord
