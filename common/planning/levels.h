// The levels of the solver hierarchy that a subproblem goes through: what can be known of them
// without solving anything, so that coordinator and worker agree on it.
// Thread safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/planning/subproblem.h"

namespace accord {

// One robot that has nobody to look out for is given its path without any of the levels.
bool is_robot_alone(const Subproblem& subproblem);

// Whether a solver is meant for such subproblems. Of others it gives up at once, with no effort.
bool is_meant_for(std::string_view solver, const Subproblem& subproblem);

// Those of the solvers that are meant for it, in order.
std::vector<std::string> levels_of(const Subproblem& subproblem,
                                   const std::vector<std::string>& solvers);

// How it went at one level.
enum class LevelOutcome : std::uint8_t { kSolved, kImproved, kExhausted };
inline constexpr std::size_t kLevelOutcomes = 3;
std::string_view to_string(LevelOutcome outcome);
LevelOutcome outcome_of(const Resolution& resolution);

struct TriedLevel {
  std::string solver;
  LevelOutcome outcome = LevelOutcome::kExhausted;

  friend bool operator==(const TriedLevel&, const TriedLevel&) = default;
};

// Which levels an attempt with these solvers went through, and how it went at each, as its
// resolution tells. At least one, but where no solver is meant for it.
std::vector<TriedLevel> tried_levels(const Subproblem& subproblem,
                                     const std::vector<std::string>& solvers,
                                     const Resolution& resolution);

}  // namespace accord
