// AdaptSubProblem of the ARC paper: how large the next subproblem of a conflict is, given how the
// earlier ones went. (Alg. 2, line 11, and "R' merges the involved robots", section IV-A)
// Not thread safe.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "common/planning/conflict.h"
#include "common/planning/schedule.h"
#include "common/planning/subproblem.h"
#include "coordinator/conflict_board.h"
#include "coordinator/subproblem_factory.h"

namespace accord {

class Adaptation {
 public:
  // Both must outlive this.
  Adaptation(const SubproblemFactory& factory, const Schedule& schedule)
      : factory_(factory), schedule_(schedule) {}

  // A copy for a copy of the schedule.
  Adaptation(const Adaptation& other, const Schedule& schedule)
      : factory_(other.factory_),
        schedule_(schedule),
        stages_(other.stages_),
        trades_(other.trades_),
        lockstep_is_spent_(other.lockstep_is_spent_),
        windows_grown_(other.windows_grown_),
        robots_taken_in_(other.robots_taken_in_) {}

  // How far the conflict's subproblem has been grown. Where resolving the conflict has only brought
  // it back, with all robots that earlier resolutions tied to it; where too many robots are
  // entangled with it for local planning, with all of these, as a crowd.
  Growth growth_of(const Conflict& conflict, const ConflictBoard& board) const;

  // Whether the conflict's subproblem has only been solved at the cost of long delays where more
  // robots are entangled, so that they should be planned together, as a crowd: the next one will.
  bool prefers_crowd(const Conflict& conflict, const Subproblem& subproblem,
                     const Resolution& resolution, const ConflictBoard& board);

  // The conflict's subproblem was solved and committed.
  void note_resolved(const Conflict& conflict, const Subproblem& subproblem);

  // The conflict's subproblem was exhausted: the next one is larger. `in_the_way`: outsiders that a
  // solution without outsiders would have run into. False when nothing is left to grow.
  bool grow(const Conflict& conflict, const Subproblem& subproblem,
            const std::vector<RobotId>& in_the_way, const ConflictBoard& board);

  // How far beyond the earliest conflict (s) others matter for how it is resolved, usually.
  double reach() const;

  std::uint64_t windows_grown() const { return windows_grown_; }
  std::uint64_t robots_taken_in() const { return robots_taken_in_; }

 private:
  using Pair = std::pair<RobotId, RobotId>;

  // Resolutions of a pair's conflicts that keep coming back at about the same time.
  struct Trade {
    unsigned count = 0;
    double from = 0;   // s
    double until = 0;  // s
  };

  // A conflict's subproblem as a local one and as a crowd's, each grown on its own.
  struct Stages {
    Growth local;
    Growth crowd;
    bool wants_crowd = false;
    bool has_bystanders = false;
    bool crowd_is_spent = false;  // has been tried as far as it goes
    bool has_local = false;       // a local solution, but a costly one
  };

  bool is_for_lockstep(const Conflict& conflict, const Growth& crowd) const;
  const Trade* trade_of(const Conflict& conflict) const;
  Growth crowd_of(const Conflict& conflict, Growth growth, const ConflictBoard& board) const;
  bool grow_local(const Subproblem& subproblem, const std::vector<RobotId>& candidates,
                  Growth& growth);
  bool grow_crowd(const Subproblem& subproblem, const std::vector<RobotId>& candidates,
                  Growth& growth);
  std::size_t take_in(const std::vector<RobotId>& candidates, std::size_t most, Growth& growth);
  bool grow_window(const Subproblem& subproblem, Growth& growth);

  const SubproblemFactory& factory_;
  const Schedule& schedule_;
  std::map<Pair, Stages> stages_;
  std::map<Pair, Trade> trades_;
  bool lockstep_is_spent_ = false;  // what it has left is for others
  std::uint64_t windows_grown_ = 0;
  std::uint64_t robots_taken_in_ = 0;
};

}  // namespace accord
