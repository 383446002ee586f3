// The workforce that planning sees, whoever works: takes subproblems up the levels of the hierarchy
// with the hands of a crew. Hands that would idle try levels ahead of need, and then what planning
// foresees that it will ask for. What comes back is what SolverHierarchy gives, one subproblem
// after another (see Ladder): all that was done ahead is to have the answer, or a part of it, at
// hand when the very same subproblem is asked for. Not thread safe.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
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
                                const std::atomic<bool>& stop, const Foresight& foresight) override;
  std::uint64_t asked() const override { return asked_so_far_; }

 private:
  using Ladders = std::vector<std::unique_ptr<Ladder>>;
  struct UnderWay {
    Ladder* ladder;
    std::size_t rung;
    bool is_ahead;
  };

  std::unique_ptr<Ladder> make_ladder(const Subproblem& subproblem) const;
  // The ladder of the very same subproblem, which is taken out; a new one where there is none.
  std::unique_ptr<Ladder> take_ladder(const Subproblem& subproblem, Ladders& from) const;
  void work(const std::atomic<bool>& stop, const Foresight& foresight);
  void begin(Ladder& ladder, std::size_t rung, bool is_ahead);
  // Begins, or hurries, what a ladder that is asked for needs next, if anything.
  void begin_needed(Ladder& ladder);
  void begin_ahead(const Ladders& ladders);
  void foresee(const Foresight& foresight);
  std::optional<Resolution> likely(const Subproblem& subproblem, const Ladders& foreseen) const;
  void note(Attempted attempted);
  // What was begun, to the crew.
  void hand_over();
  void drop(const Ladders& ladders);

  std::unique_ptr<Crew> crew_;
  std::vector<std::string> solvers_;
  WorkEstimate estimate_;
  Ticket next_ticket_ = 1;
  Ladders asked_;     // by solve(), in its order
  Ladders foreseen_;  // soonest first
  std::map<Ticket, UnderWay> under_way_;
  std::vector<Attempt> begun_;  // not handed over yet
  std::size_t undecided_ = 0;   // of those asked for
  std::uint64_t asked_so_far_ = 0;
  bool has_news_ = false;  // since foresight was asked
  double waited_ = 0;      // s: for work, so far, about
  double foresaw_ = 0;     // s: what foresight has taken so far
};

}  // namespace accord
