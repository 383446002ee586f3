// Runs ahead of ARC on copies of its state: settles what is likely to become of the subproblems
// that are being solved, and of those after them, without waiting for the rest, and sees which
// subproblems come next. Its only product are guesses at what ARC will ask for: where they are
// right, somebody has begun it already; where not, nothing has happened.
// Not thread safe.
#pragma once

#include <vector>

#include "coordinator/round.h"
#include "coordinator/workforce.h"

namespace accord {

class Forerunner {
 public:
  // All must outlive this; they are only read, and stay as they are at the round's beginning.
  Forerunner(const CollisionWorld& planning, const SubproblemFactory& factory,
             const Schedule& schedule, const ConflictBoard& board, const Adaptation& adaptation)
      : planning_(planning),
        factory_(factory),
        schedule_(schedule),
        board_(board),
        adaptation_(adaptation) {}

  // What ARC may ask for after these jobs, soonest first: at most `most` subproblems of which
  // nothing is known, and those that led to them. `are_known`: the jobs have their resolutions;
  // else these are what is likely.
  std::vector<Subproblem> look_ahead(const std::vector<Job>& jobs, bool are_known,
                                     const Likely& likely, std::size_t most) const;

 private:
  const CollisionWorld& planning_;
  const SubproblemFactory& factory_;
  const Schedule& schedule_;
  const ConflictBoard& board_;
  const Adaptation& adaptation_;
};

}  // namespace accord
