// One round of ARC: which subproblems are solved next, and what becomes of the schedule, its
// conflicts and the growth of subproblems when they are. (Alg. 1, lines 6 to 11, and Alg. 2)
// A round's choice depends on these three alone; hence the plan does not depend on how many workers
// there are, and who works on copies of them may look ahead.
// Not thread safe.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "common/planning/conflict.h"
#include "common/planning/schedule.h"
#include "common/planning/subproblem.h"
#include "coordinator/adaptation.h"
#include "coordinator/conflict_board.h"
#include "coordinator/subproblem_factory.h"

namespace accord {

struct Job {
  Conflict conflict;
  Subproblem subproblem;
  Resolution resolution;
  std::vector<RobotId> in_the_way;  // of an exhausted one: outsiders to take in
  std::uint64_t number = 0;         // Workforce::asked() when it was asked for

  bool is_exhausted() const { return !resolution.solved && !resolution.improves(); }
  // Exhausted for outsiders: what is in the way is to be found out.
  bool is_in_question() const { return is_exhausted() && !subproblem.outsiders.empty(); }
};

// A job's subproblem without its outsiders, whose solution shows who is in the way.
Subproblem without_outsiders(const Subproblem& subproblem);
// The outsiders that a solution without outsiders would run into, earliest first.
std::vector<RobotId> hit_by(const CollisionWorld& world, const Subproblem& subproblem,
                            const Resolution& without);

// What rounds change. All must outlive this.
class Round {
 public:
  Round(const SubproblemFactory& factory, Schedule& schedule, ConflictBoard& board,
        Adaptation& adaptation)
      : factory_(factory), schedule_(schedule), board_(board), adaptation_(adaptation) {}

  // Whether there are conflicts left; looks as far ahead as matters for the next choice.
  bool look_ahead();

  // The earliest conflicts first; each robot's own earliest only; none whose robots another chosen
  // one has to avoid, or the other way round. `pending`: subproblems that are not settled yet count
  // as chosen before all others.
  std::vector<Job> choose(const std::vector<const Subproblem*>& pending = {}) const;

  enum class Settled : std::uint8_t {
    kCommitted,
    kNotWorthwhile,  // solved, but a larger subproblem is to be tried instead
    kLeft,           // the conflict is left, and its next subproblem is larger; what helps others
                     // was committed
    kHopeless,       // and nothing is left to grow
  };
  // Commits what a job came to, or grows its conflict's subproblem. Throws std::logic_error when
  // its resolution does not fit.
  Settled settle(const Job& job);

 private:
  void commit(const Job& job);

  const SubproblemFactory& factory_;
  Schedule& schedule_;
  ConflictBoard& board_;
  Adaptation& adaptation_;
};

}  // namespace accord
