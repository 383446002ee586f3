#include "coordinator/work_estimate.h"

#include <algorithm>

namespace accord {
namespace {

// How much of the past is remembered.
constexpr double kMemory = 0.7;
// Of one solver, for each pair of robots' pairs of degrees of freedom: 0.3 ms for two discs, 3 ms
// for two arms of six joints.
constexpr double kPrior = 2e-5;  // s

std::size_t largest_dof(const Subproblem& subproblem) {
  std::size_t dof = 0;
  for (const Task& task : subproblem.tasks) dof = std::max(dof, task.start.size());
  return dof;
}

}  // namespace

double WorkEstimate::seconds(const Subproblem& subproblem,
                             const std::vector<std::string>& solvers) const {
  const std::size_t robots = subproblem.tasks.size(), dof = largest_dof(subproblem);
  const auto known = seconds_.find({solvers, robots, dof});
  if (known != seconds_.end()) return known->second;
  const auto size = static_cast<double>(robots * dof);
  return kPrior * size * size * static_cast<double>(std::max<std::size_t>(1, solvers.size()));
}

void WorkEstimate::learn(const Subproblem& subproblem, const std::vector<std::string>& solvers,
                         double seconds) {
  const Kind kind{solvers, subproblem.tasks.size(), largest_dof(subproblem)};
  const auto [known, is_new] = seconds_.try_emplace(kind, seconds);
  if (!is_new) known->second = kMemory * known->second + (1 - kMemory) * seconds;
}

}  // namespace accord
