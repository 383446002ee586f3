#include "coordinator/whole_problem.h"

#include <stdexcept>

namespace accord {

Outcome WholeProblem::resolve(ConflictBoard& board) {
  if (!board.look_at_all()) return {PlanStatus::kSolved, ""};
  statistics_.conflicts_found = board.found();
  report_conflicts(board.size());
  const Subproblem subproblem = factory_.create_whole(schedule_);
  const Resolution resolution = workforce_.solve({subproblem}, stop_, {}).front();
  ++statistics_.rounds;
  ++statistics_.subproblems;
  statistics_.effort += resolution.effort;
  if (!resolution.solved) {
    ++statistics_.exhausted;
    return stop_ ? stopped(scene(), board)
                 : unresolved(scene(), *board.conflicts().begin(), subproblem);
  }
  if (!schedule_.commit(subproblem, resolution, workforce_.asked())) {
    throw std::logic_error(resolution.solver + " returned paths that do not fit the problem");
  }
  ++statistics_.solved_by[resolution.solver];
  statistics_.conflicts_resolved = statistics_.conflicts_found;
  return {PlanStatus::kSolved, ""};
}

}  // namespace accord
