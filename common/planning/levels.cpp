#include "common/planning/levels.h"

#include <utility>

namespace accord {

bool is_robot_alone(const Subproblem& subproblem) {
  return subproblem.tasks.size() == 1 && subproblem.outsiders.empty();
}

bool is_meant_for(std::string_view solver, const Subproblem& subproblem) {
  if (solver == "lockstep-query") return subproblem.lockstep;
  if (subproblem.lockstep) return false;
  if (solver == "cbs-mp") return subproblem.is_last();
  // Too many for one space.
  if (solver.starts_with("composite-")) return !subproblem.is_crowd();
  return true;
}

std::vector<std::string> levels_of(const Subproblem& subproblem,
                                   const std::vector<std::string>& solvers) {
  std::vector<std::string> levels;
  for (const std::string& solver : solvers) {
    if (is_meant_for(solver, subproblem)) levels.push_back(solver);
  }
  return levels;
}

std::string_view to_string(LevelOutcome outcome) {
  switch (outcome) {
    case LevelOutcome::kSolved:
      return "solved";
    case LevelOutcome::kImproved:
      return "improved";
    case LevelOutcome::kExhausted:
      break;
  }
  return "exhausted";
}

LevelOutcome outcome_of(const Resolution& resolution) {
  if (resolution.solved) return LevelOutcome::kSolved;
  return resolution.improves() ? LevelOutcome::kImproved : LevelOutcome::kExhausted;
}

std::vector<TriedLevel> tried_levels(const Subproblem& subproblem,
                                     const std::vector<std::string>& solvers,
                                     const Resolution& resolution) {
  const LevelOutcome last = outcome_of(resolution);
  const bool has_solver = last != LevelOutcome::kExhausted;
  if (is_robot_alone(subproblem)) return {{has_solver ? resolution.solver : "prm", last}};
  std::vector<TriedLevel> tried;
  for (std::string& solver : levels_of(subproblem, solvers)) {
    if (has_solver && solver == resolution.solver) break;
    tried.push_back({std::move(solver), LevelOutcome::kExhausted});
  }
  if (has_solver) tried.push_back({resolution.solver, last});
  return tried;
}

}  // namespace accord
