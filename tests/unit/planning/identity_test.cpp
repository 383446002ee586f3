#include "common/planning/identity.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/support/problems.h"

namespace accord {
namespace {

Subproblem sample() {
  return testing::swapping_discs_and_a_passer_by().subproblem;
}

TEST(Identity, IsThatOfACopy) {
  EXPECT_TRUE(are_identical(sample(), sample()));
}

TEST(Identity, TellsZeroFromMinusZero) {
  Subproblem other = sample();
  ASSERT_EQ(other.tasks[0].start[1], 0);
  other.tasks[0].start[1] = -0.0;
  EXPECT_EQ(other.tasks[0].start, sample().tasks[0].start);
  EXPECT_FALSE(are_identical(other, sample()));
}

TEST(Identity, IsLostWithAChangeOfAnyField) {
  const std::vector<std::function<void(Subproblem&)>> changes{
      [](Subproblem& s) { ++s.seed; },
      [](Subproblem& s) { s.from = 1; },
      [](Subproblem& s) { s.to = 1; },
      [](Subproblem& s) { s.horizon = 1; },
      [](Subproblem& s) { s.clear_until = 1; },
      [](Subproblem& s) { s.lockstep = true; },
      [](Subproblem& s) { s.whole = false; },
      [](Subproblem& s) { ++s.limits.last_factor; },
      [](Subproblem& s) { s.tasks.pop_back(); },
      [](Subproblem& s) { s.tasks[1].robot = {2}; },
      [](Subproblem& s) { ++s.tasks[1].version; },
      [](Subproblem& s) { s.tasks[1].start[0] += 1e-15; },
      [](Subproblem& s) { s.tasks[1].to = 1; },
      [](Subproblem& s) { s.tasks[1].goal[1] = 1; },
      [](Subproblem& s) { s.tasks[1].region.lower[1] = 1; },
      [](Subproblem& s) { s.tasks[1].region.upper[1] = 1; },
      [](Subproblem& s) { s.tasks[1].guide.append(99, s.tasks[1].goal); },
      [](Subproblem& s) { s.tasks[1].tail = s.tasks[1].guide; },
      [](Subproblem& s) { s.tasks[1].roadmap_level = 0; },
      [](Subproblem& s) { s.outsiders.clear(); },
      [](Subproblem& s) { s.outsiders[0].robot = {1}; },
      [](Subproblem& s) { ++s.outsiders[0].version; },
      [](Subproblem& s) { s.outsiders[0].path.append(99, s.tasks[1].goal); },
      [](Subproblem& s) { s.outsiders[0].until = 1; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Subproblem other = sample();
    changes[i](other);
    EXPECT_FALSE(are_identical(other, sample())) << "change " << i;
    EXPECT_FALSE(are_identical(sample(), other)) << "change " << i;
  }
}

}  // namespace
}  // namespace accord
