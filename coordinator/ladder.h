// One subproblem's way up the levels of the solver hierarchy, some of which may be tried ahead of
// need: before it is known that those below have failed. What comes out is what they give when they
// are tried one after another, as SolverHierarchy does: the resolution of the first in order that
// solves it, with its own effort and that of those below. (Alg. 2, lines 3 to 8)
// Not thread safe.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/planning/subproblem.h"
#include "coordinator/crew.h"

namespace accord {

class Ladder {
 public:
  // `rungs`: the solvers that each attempt tries in order; all together the hierarchy. Those of
  // none are exhausted at once.
  Ladder(std::shared_ptr<const Subproblem> subproblem, std::vector<std::vector<std::string>> rungs);

  const std::shared_ptr<const Subproblem>& subproblem() const { return subproblem_; }
  const std::vector<std::string>& solvers(std::size_t rung) const { return rungs_[rung].solvers; }

  // The lowest rung that is not known to fail, if it was not tried yet or is under way. Its outcome
  // is needed. nullopt: the subproblem is decided.
  std::optional<std::size_t> needed() const;
  // The lowest rung above that which may be begun ahead of need; none where one below has solved
  // it.
  std::optional<std::size_t> next_ahead() const;

  // Whether a rung may be begun ahead of need.
  bool is_open(std::size_t rung) const { return rungs_[rung].stage == Stage::kOpen; }
  // The attempt at a rung that is under way.
  std::optional<Ticket> ticket(std::size_t rung) const;
  // Requires: the rung is not under way, and has not ended.
  void begin(std::size_t rung, Ticket ticket);
  // The attempt came to nothing: it is not to be begun again ahead of need.
  void put_off(std::size_t rung) { rungs_[rung].stage = Stage::kPutOff; }
  // How the attempt at a rung that was under way has ended. Returns those under way that need not
  // be: above a rung that has solved it.
  std::vector<Ticket> end(std::size_t rung, Resolution resolution, Doer doer = {});

  bool is_decided() const { return !needed(); }
  // What it will be, as far as can be told: the resolution of the lowest rung that has solved it,
  // whatever comes of those under way below; or exhausted, where all but one have failed. Without
  // effort. nullopt: too early to say.
  std::optional<Resolution> likely() const;
  // Requires: is_decided().
  Resolution take();

  // What led to the resolution: the rungs below the one that has solved it, and that one. For the
  // log, before take(). Requires: is_decided().
  struct Climbed {
    const std::vector<std::string>& solvers;
    const Resolution& resolution;
    const Doer& doer;
  };
  std::vector<Climbed> climbed() const;

 private:
  enum class Stage { kOpen, kPutOff, kBegun, kFailed, kSolved };
  struct Rung {
    std::vector<std::string> solvers;
    Stage stage = Stage::kOpen;
    Ticket ticket = 0;  // of one that was begun
    Resolution resolution;
    Doer doer;
  };

  std::shared_ptr<const Subproblem> subproblem_;
  std::vector<Rung> rungs_;
};

}  // namespace accord
