// The baselines: each robot alone first, and if any two of these paths conflict, the whole problem
// as one subproblem of all robots, from start to goal, for one solver that goes on until it has
// solved it or is stopped. What ARC would do if it grew every subproblem as far as it goes at once.
#pragma once

#include "coordinator/method.h"

namespace accord {

class WholeProblem final : public Method {
 public:
  // As Method's. The workforce's hierarchy is the one solver.
  using Method::Method;

 private:
  Outcome resolve(ConflictBoard& board) override;
};

}  // namespace accord
