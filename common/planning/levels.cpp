#include "common/planning/levels.h"

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

}  // namespace accord
