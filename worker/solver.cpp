#include "worker/solver.h"

#include <spdlog/spdlog.h>

#include <stdexcept>

#include "common/planning/levels.h"
#include "worker/cbs_mp.h"
#include "worker/composite_prm.h"
#include "worker/composite_rrt_connect.h"
#include "worker/decoupled_prm.h"
#include "worker/lockstep_query.h"
#include "worker/prioritized_query.h"

namespace accord {
namespace {

void log(std::string_view solver, const Resolution& resolution) {
  const Effort& effort = resolution.effort;
  spdlog::debug("{}: {} ({} searches, {} expansions, {} samples, {} motion checks)", solver,
                resolution.solved       ? "solved"
                : resolution.improves() ? "improved"
                                        : "exhausted",
                effort.searches, effort.expansions, effort.samples, effort.motion_checks);
}

}  // namespace

Resolution Solver::solve(const Workspace& workspace, const Subproblem& subproblem,
                         const std::atomic<bool>& stop) const {
  if (subproblem.tasks.empty() || !takes(subproblem) || stop) return {};
  return do_solve(workspace, subproblem, stop);
}

bool Solver::takes(const Subproblem& subproblem) const {
  return is_meant_for(name(), subproblem);
}

std::unique_ptr<Solver> make_solver(std::string_view name) {
  if (name == LockstepQuery::kName) return std::make_unique<LockstepQuery>();
  if (name == PrioritizedQuery::kName) return std::make_unique<PrioritizedQuery>();
  if (name == DecoupledPrm::kName) return std::make_unique<DecoupledPrm>();
  if (name == CbsMp::kName) return std::make_unique<CbsMp>();
  if (name == CompositeRrtConnect::kName) return std::make_unique<CompositeRrtConnect>();
  if (name == CompositePrm::kName) return std::make_unique<CompositePrm>();
  return nullptr;
}

SolverHierarchy::SolverHierarchy(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    solvers_.push_back(make_solver(name));
    if (!solvers_.back()) throw std::invalid_argument("unknown solver \"" + name + "\"");
  }
}

Resolution SolverHierarchy::do_solve(const Workspace& workspace, const Subproblem& subproblem,
                                     const std::atomic<bool>& stop) const {
  Effort effort;
  for (const auto& solver : solvers_) {
    Resolution resolution = solver->solve(workspace, subproblem, stop);
    effort += resolution.effort;
    log(solver->name(), resolution);
    resolution.effort = effort;
    if (resolution.solved || resolution.improves() || stop) return resolution;
  }
  Resolution exhausted;
  exhausted.effort = effort;
  return exhausted;
}

}  // namespace accord
