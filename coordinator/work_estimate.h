// How long attempts take, guessed from those that have ended. Decides who is given what and what is
// worth beginning ahead of need; never what comes back, which must not depend on speeds.
// Not thread safe.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "common/planning/subproblem.h"

namespace accord {

class WorkEstimate {
 public:
  // s: of an attempt that tries these solvers in order until one succeeds.
  double seconds(const Subproblem& subproblem, const std::vector<std::string>& solvers) const;
  // It took so long (s).
  void learn(const Subproblem& subproblem, const std::vector<std::string>& solvers, double seconds);

 private:
  // Solvers; robots; the degrees of freedom of the one that has most.
  using Kind = std::tuple<std::vector<std::string>, std::size_t, std::size_t>;

  std::map<Kind, double> seconds_;  // of late
};

}  // namespace accord
