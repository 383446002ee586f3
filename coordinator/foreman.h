// The workforce that planning sees, whoever works: takes subproblems up the levels of the hierarchy
// with the hands of a crew, and tries levels ahead of need with hands that would idle. What comes
// back is what SolverHierarchy gives, one subproblem after another; see Ladder.
// Not thread safe.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "coordinator/crew.h"
#include "coordinator/ladder.h"
#include "coordinator/work_estimate.h"
#include "coordinator/workforce.h"

namespace accord {

class Foreman final : public Workforce {
 public:
  // `solvers`: the hierarchy, in order.
  Foreman(std::unique_ptr<Crew> crew, std::vector<std::string> solvers)
      : crew_(std::move(crew)), solvers_(std::move(solvers)) {}

  // Throws what the crew says of an attempt that is needed and that nobody could carry out.
  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>& stop) override;

 private:
  struct UnderWay {
    Ladder* ladder;
    std::size_t rung;
    bool is_ahead;
  };

  Ladder make_ladder(const Subproblem& subproblem) const;
  void begin(Ladder& ladder, std::size_t rung, bool is_ahead);
  // Begins, or hurries, what the ladder needs next, if anything.
  void begin_needed(Ladder& ladder);
  void begin_ahead(std::vector<Ladder>& ladders);
  void note(Attempted attempted);
  // What was begun, to the crew.
  void hand_over();
  void drop_all();

  std::unique_ptr<Crew> crew_;
  std::vector<std::string> solvers_;
  WorkEstimate estimate_;
  Ticket next_ticket_ = 1;
  std::map<Ticket, UnderWay> under_way_;
  std::vector<Attempt> begun_;  // not handed over yet
  std::size_t undecided_ = 0;   // of those that solve() is asked for
};

}  // namespace accord
