#include "coordinator/foreman.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "common/io/wire/resolution_codec.h"
#include "common/planning/random.h"
#include "tests/support/scenes.h"
#include "tests/unit/coordinator/scripted_crew.h"

namespace accord {
namespace {

using testing::ScriptedCrew;

const std::vector<std::string> kSolvers{"lockstep-query", "prioritized-query", "decoupled-prm",
                                        "composite-prm"};
const std::vector<std::string> kLevels{"prioritized-query", "decoupled-prm", "composite-prm"};

// Of so many arms: long work, as far as anybody can guess.
Subproblem team(std::uint64_t seed, std::size_t robots = 2, std::size_t dof = 6) {
  Subproblem out;
  out.seed = seed;
  for (std::uint32_t id = 0; id < robots; ++id) {
    Task task{};
    task.robot = {id};
    task.start = Configuration(dof);
    out.tasks.push_back(task);
  }
  return out;
}

class ForemanTest : public ::testing::Test {
 protected:
  std::vector<Resolution> solve(std::size_t hands, const std::vector<Subproblem>& subproblems) {
    auto crew = std::make_unique<ScriptedCrew>(hands);
    crew_ = crew.get();
    crew_->outcome = outcome_;
    crew_->next = next_;
    foreman_.emplace(std::move(crew), kSolvers);
    return foreman_->solve(subproblems, stop_, foresight_);
  }

  std::vector<std::string> begun_ahead() const {
    std::vector<std::string> out;
    for (const Attempt& attempt : crew_->begun) {
      if (attempt.is_ahead) out.push_back(attempt.solvers.front());
    }
    return out;
  }

  std::atomic<bool> stop_{false};
  std::function<Attempted(const Attempt&)> outcome_ = [](const Attempt&) { return Attempted{}; };
  std::function<std::size_t(std::size_t)> next_ = [](std::size_t) { return 0U; };
  Foresight foresight_;
  ScriptedCrew* crew_ = nullptr;
  std::optional<Foreman> foreman_;
};

// What becomes of a level, at random but always the same.
Resolution outcome_of(const Subproblem& subproblem, const std::string& solver) {
  RandomStream random(combine({subproblem.seed, std::hash<std::string>{}(solver)}));
  Resolution out;
  out.effort = {random.below(100), random.below(100), random.below(100), random.below(100),
                random.below(100)};
  out.solved = random.below(3) == 0;
  if (out.solved) out.solver = solver;
  return out;
}

// As SolverHierarchy does it.
Resolution one_after_another(const Subproblem& subproblem, const std::vector<std::string>& levels) {
  Effort effort;
  for (const std::string& solver : levels) {
    Resolution resolution = outcome_of(subproblem, solver);
    effort += resolution.effort;
    resolution.effort = effort;
    if (resolution.solved) return resolution;
  }
  Resolution exhausted;
  exhausted.effort = effort;
  return exhausted;
}

TEST_F(ForemanTest, GivesWhatOneLevelAfterAnotherGivesWhateverEndsFirst) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    RandomStream random(seed);
    outcome_ = [&](const Attempt& attempt) {
      Attempted out;
      out.seconds = 1e-3 * static_cast<double>(random.below(20));
      // What is begun ahead of need may fail of its workers' deaths.
      if (attempt.is_ahead && random.below(5) == 0) {
        out.failure = std::make_exception_ptr(std::runtime_error("nobody survives it"));
        return out;
      }
      out.resolution = one_after_another(*attempt.subproblem, attempt.solvers);
      return out;
    };
    next_ = [&](std::size_t under_way) { return random.below(under_way); };
    std::vector<Subproblem> subproblems;
    for (std::uint64_t i = 0; i <= random.below(5); ++i) {
      subproblems.push_back(team(combine({seed, i}), 2, 1 + random.below(6)));
    }
    // What is foreseen may be asked for or not, and may be something else each time.
    const auto later = team(combine({seed, 77}));
    foresight_ = [&](const Likely& likely, std::size_t) {
      std::vector<Subproblem> out;
      if (random.below(3) > 0) out.push_back(later);
      if (random.below(3) > 0) out.push_back(team(random.next()));
      for (const Subproblem& subproblem : subproblems) {
        if (likely(subproblem)) out.push_back(team(combine({subproblem.seed, 5})));
      }
      return out;
    };
    const auto check = [&](const std::vector<Resolution>& resolutions) {
      for (std::size_t i = 0; i < subproblems.size(); ++i) {
        ASSERT_EQ(encode_resolution(resolutions[i]),
                  encode_resolution(one_after_another(subproblems[i], kLevels)))
            << "seed " << seed;
      }
    };
    check(solve(1 + random.below(7), subproblems));
    subproblems = {later, team(combine({subproblems.front().seed, 5}))};
    check(foreman_->solve(subproblems, stop_, foresight_));
  }
}

TEST_F(ForemanTest, HasWhatItForesawAtHandWhenTheVerySameIsAskedFor) {
  outcome_ = [](const Attempt& attempt) {
    Attempted out;
    out.seconds = 0.1;
    out.resolution.solved = attempt.solvers.front() == "composite-prm";
    return out;
  };
  foresight_ = [](const Likely&, std::size_t) { return std::vector<Subproblem>{team(2)}; };
  solve(6, {team(1)});
  const std::size_t begun = crew_->begun.size();
  EXPECT_EQ(begun, 6U) << "three levels of each";
  foreman_->solve({team(2)}, stop_, {});
  EXPECT_EQ(crew_->begun.size(), begun) << "all of it was under way";
}

// Not even what differs by a sign of zero.
TEST_F(ForemanTest, TakesNothingElseForWhatIsAskedFor) {
  outcome_ = [](const Attempt& attempt) {
    Attempted out;
    out.seconds = 0.1;
    out.resolution.solved = true;
    out.resolution.solver = std::signbit(attempt.subproblem->from) ? "minus" : "plus";
    return out;
  };
  foresight_ = [](const Likely&, std::size_t) { return std::vector<Subproblem>{team(2)}; };
  solve(6, {team(1)});
  Subproblem other = team(2);
  other.from = -0.0;
  EXPECT_EQ(foreman_->solve({other}, stop_, {}).front().solver, "minus");
}

TEST_F(ForemanTest, DropsWhatIsNotForeseenAnyMore) {
  std::uint64_t seed = 1;
  outcome_ = [](const Attempt&) {
    Attempted out;
    out.seconds = 0.1;
    return out;
  };
  foresight_ = [&](const Likely&, std::size_t) { return std::vector<Subproblem>{team(++seed)}; };
  solve(6, {team(1)});
  EXPECT_FALSE(crew_->dropped.empty());
  std::set<std::uint64_t> seeds;
  for (const Attempt& attempt : crew_->under_way) seeds.insert(attempt.subproblem->seed);
  EXPECT_LE(seeds.size(), 1U) << "nobody works on what was foreseen before";
}

TEST_F(ForemanTest, AsksForNoForesightWhileAllHandsAreNeeded) {
  bool was_asked = false;
  foresight_ = [&](const Likely&, std::size_t) {
    was_asked = true;
    return std::vector<Subproblem>{};
  };
  solve(1, {team(1), team(2)});
  EXPECT_FALSE(was_asked);
}

TEST_F(ForemanTest, TellsForesightWhatIsLikely) {
  // The last level has solved it; the second one is still being tried.
  next_ = [](std::size_t under_way) { return under_way - 1; };
  outcome_ = [](const Attempt& attempt) {
    Attempted out;
    out.seconds = 0.1;
    out.resolution.solved = attempt.solvers.front() == "composite-prm";
    out.resolution.solver = attempt.solvers.front();
    out.resolution.effort.searches = 3;
    return out;
  };
  std::vector<std::string> likely_solvers;
  foresight_ = [&](const Likely& likely, std::size_t) {
    const auto resolution = likely(team(1));
    if (resolution && resolution->solved) likely_solvers.push_back(resolution->solver);
    EXPECT_TRUE(!resolution || resolution->effort.searches == 0);
    EXPECT_FALSE(likely(team(9)));
    return std::vector<Subproblem>{};
  };
  EXPECT_TRUE(solve(4, {team(1)}).front().solved);
  EXPECT_FALSE(likely_solvers.empty());
}

TEST_F(ForemanTest, LetsHandsThatWouldIdleTryLaterLevels) {
  solve(2, {team(1)});
  EXPECT_EQ(crew_->most_under_way, 2U);
  EXPECT_EQ(begun_ahead(), (std::vector<std::string>{"decoupled-prm", "composite-prm"}));
}

TEST_F(ForemanTest, BeginsNothingAheadWhileAllHandsAreNeeded) {
  solve(1, {team(1)});
  EXPECT_TRUE(begun_ahead().empty());
  solve(2, {team(1), team(2), team(3)});
  ASSERT_GE(crew_->begun.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(crew_->begun[i].is_ahead);
}

TEST_F(ForemanTest, DropsLaterLevelsOnceAnEarlierOneHasSolvedIt) {
  outcome_ = [](const Attempt&) {
    Attempted out;
    out.resolution.solved = true;
    return out;
  };
  solve(3, {team(1)});
  EXPECT_EQ(crew_->begun.size(), 3U);
  EXPECT_EQ(crew_->dropped.size(), 2U);
  EXPECT_TRUE(crew_->under_way.empty());
}

TEST_F(ForemanTest, TellsTheCrewWhatHasBecomeNeeded) {
  std::set<std::string> needed;
  outcome_ = [&](const Attempt& attempt) {
    if (!attempt.is_ahead) needed.insert(attempt.solvers.front());
    return Attempted{};
  };
  solve(3, {team(1)});
  EXPECT_EQ(needed, std::set<std::string>(kLevels.begin(), kLevels.end()));
}

TEST_F(ForemanTest, MakesOneAttemptOfAllLevelsWhereTheyTakeNoTime) {
  solve(4, {team(1, 2, 2)});
  ASSERT_EQ(crew_->begun.size(), 1U);
  EXPECT_EQ(crew_->begun[0].solvers, kLevels);
}

TEST_F(ForemanTest, LearnsWhichOnesTakeLong) {
  outcome_ = [](const Attempt&) {
    Attempted out;
    out.seconds = 0.1;
    return out;
  };
  solve(4, {team(1, 2, 2)});
  foreman_->solve({team(2, 2, 2)}, stop_, {});
  EXPECT_EQ(crew_->begun.size(), 4U);
}

TEST_F(ForemanTest, AsksOnlySolversThatAreMeantForIt) {
  Subproblem lockstep = team(1);
  lockstep.lockstep = true;
  solve(4, {lockstep});
  ASSERT_EQ(crew_->begun.size(), 1U);
  EXPECT_EQ(crew_->begun[0].solvers, (std::vector<std::string>{"lockstep-query"}));
}

TEST_F(ForemanTest, AsksNobodyWhereNoSolverIsMeantForIt) {
  Foreman foreman(std::make_unique<ScriptedCrew>(2), {"lockstep-query"});
  EXPECT_FALSE(foreman.solve({team(1)}, stop_, {}).front().solved);
}

TEST_F(ForemanTest, ThrowsWhatNobodyCouldCarryOutIfItIsNeeded) {
  outcome_ = [](const Attempt&) {
    Attempted out;
    out.failure = std::make_exception_ptr(std::runtime_error("nobody survives it"));
    return out;
  };
  EXPECT_THROW(solve(3, {team(1)}), std::runtime_error);
  EXPECT_TRUE(crew_->under_way.empty());
}

TEST_F(ForemanTest, AsksAgainWhenWhatFailedAheadOfNeedIsNeeded) {
  next_ = [](std::size_t under_way) { return under_way - 1; };
  outcome_ = [](const Attempt& attempt) {
    Attempted out;
    if (attempt.is_ahead) out.failure = std::make_exception_ptr(std::runtime_error("it died"));
    return out;
  };
  EXPECT_FALSE(solve(2, {team(1)}).front().solved);
  std::map<std::string, int> tries;
  for (const Attempt& attempt : crew_->begun) ++tries[attempt.solvers.front()];
  EXPECT_EQ(tries["decoupled-prm"], 2) << "once ahead, once needed, and not again and again";
}

TEST_F(ForemanTest, LeavesThingsUnsolvedWhenItIsStopped) {
  outcome_ = [this](const Attempt&) {
    stop_ = true;
    return Attempted{};
  };
  EXPECT_FALSE(solve(2, {team(1), team(2)}).front().solved);
  EXPECT_TRUE(crew_->under_way.empty());
}

TEST_F(ForemanTest, NumbersWhatItIsAskedForInItsOrder) {
  outcome_ = [](const Attempt& attempt) {
    Attempted out;
    out.resolution.solved = true;
    out.resolution.solver = attempt.solvers.front();
    return out;
  };
  solve(4, {team(1), team(2)});
  EXPECT_EQ(foreman_->asked(), 2U);
  foreman_->solve({team(3)}, stop_, foresight_);
  EXPECT_EQ(foreman_->asked(), 3U) << "whatever was begun ahead";
}

}  // namespace
}  // namespace accord
