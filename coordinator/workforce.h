// Whoever solves subproblems for a method of planning: the Foreman, or a test's script.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "common/planning/subproblem.h"

namespace accord {

// What is likely to become of a subproblem that is being solved, or was foreseen, as far as it can
// be told; without its effort. nullopt: not yet.
using Likely = std::function<std::optional<Resolution>(const Subproblem&)>;

// What may be asked for next, soonest first, given what is likely; with at most `most` of which
// nothing is known. Guesses: nothing but the time that is taken depends on them.
using Foresight = std::function<std::vector<Subproblem>(const Likely& likely, std::size_t most)>;

class Workforce {
 public:
  virtual ~Workforce() = default;

  // The resolution of each subproblem, in the same order. May solve them in any order or at the
  // same time; what comes back depends on the subproblems alone, unless `stop` becomes true, which
  // leaves some unsolved. `foresight` may be called meanwhile, for who would idle; may be empty.
  virtual std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                        const std::atomic<bool>& stop,
                                        const Foresight& foresight) = 0;

  // How many it has been asked for so far, by which logs number them, from 1: the same request asks
  // for the same ones in the same order. 0: it does not count.
  virtual std::uint64_t asked() const { return 0; }
};

}  // namespace accord
