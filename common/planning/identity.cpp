#include "common/planning/identity.h"

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace accord {
namespace {

// Structures are taken apart by structured bindings, so that a field that is added fails to compile
// until it is compared.

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}

bool same(const Trajectory& a, const Trajectory& b) {
  if (a.dof() != b.dof() || !same(a.times(), b.times())) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a.configuration(i), b.configuration(i))) return false;
  }
  return true;
}

bool same(const Region& a, const Region& b) {
  const auto& [lower, upper] = a;
  return same(lower, b.lower) && same(upper, b.upper);
}

bool same(const Task& a, const Task& b) {
  const auto& [robot, version, start, to, goal, region, guide, tail, roadmap_level] = a;
  return robot == b.robot && version == b.version && same(start, b.start) && same(to, b.to) &&
         same(goal, b.goal) && same(region, b.region) && same(guide, b.guide) &&
         same(tail, b.tail) && roadmap_level == b.roadmap_level;
}

bool same(const Outsider& a, const Outsider& b) {
  const auto& [robot, version, path, until] = a;
  return robot == b.robot && version == b.version && same(path, b.path) && same(until, b.until);
}

template <class Part>
bool same(const std::vector<Part>& a, const std::vector<Part>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}

}  // namespace

bool are_identical(const Subproblem& a, const Subproblem& b) {
  const auto& [seed, from, to, horizon, clear_until, lockstep, whole, tasks, outsiders, limits] = a;
  return seed == b.seed && same(from, b.from) && same(to, b.to) && same(horizon, b.horizon) &&
         same(clear_until, b.clear_until) && lockstep == b.lockstep && whole == b.whole &&
         limits == b.limits && same(tasks, b.tasks) && same(outsiders, b.outsiders);
}

}  // namespace accord
