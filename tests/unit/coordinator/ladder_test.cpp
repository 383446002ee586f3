#include "coordinator/ladder.h"

#include <gtest/gtest.h>

namespace accord {
namespace {

Resolution failed(std::uint64_t searches) {
  Resolution out;
  out.effort.searches = searches;
  return out;
}

Resolution solved(const char* solver, std::uint64_t searches) {
  Resolution out = failed(searches);
  out.solved = true;
  out.solver = solver;
  return out;
}

Ladder three() {
  return {std::make_shared<const Subproblem>(), {{"a"}, {"b"}, {"c"}}};
}

TEST(Ladder, NeedsTheLowestRungThatIsNotKnownToFail) {
  Ladder ladder = three();
  EXPECT_EQ(ladder.needed(), 0U);
  ladder.begin(0, 1);
  EXPECT_EQ(ladder.needed(), 0U);
  EXPECT_EQ(ladder.ticket(0), 1U);
  ladder.end(0, failed(1));
  EXPECT_EQ(ladder.needed(), 1U);
  EXPECT_EQ(ladder.ticket(1), std::nullopt);
}

TEST(Ladder, GivesTheLowestThatSolvesWithTheEffortOfThoseBelow) {
  Ladder ladder = three();
  for (std::size_t rung = 0; rung < 3; ++rung) ladder.begin(rung, rung + 1);
  EXPECT_TRUE(ladder.end(2, solved("c", 400)).empty());
  EXPECT_FALSE(ladder.is_decided());
  EXPECT_TRUE(ladder.end(0, failed(1)).empty());
  EXPECT_FALSE(ladder.is_decided());
  EXPECT_TRUE(ladder.end(1, solved("b", 20)).empty());
  ASSERT_TRUE(ladder.is_decided());
  const Resolution resolution = ladder.take();
  EXPECT_EQ(resolution.solver, "b");
  EXPECT_EQ(resolution.effort.searches, 21U);
}

TEST(Ladder, NamesWhatNobodyNeedsOnceALowerRungHasSolvedIt) {
  Ladder ladder = three();
  for (std::size_t rung = 0; rung < 3; ++rung) ladder.begin(rung, rung + 1);
  EXPECT_EQ(ladder.end(1, solved("b", 1)), (std::vector<Ticket>{3}));
  EXPECT_EQ(ladder.needed(), 0U) << "the one below comes first where it solves it";
}

TEST(Ladder, TakesACrowdThatIsPartlySolvedForSolved) {
  Ladder ladder = three();
  ladder.begin(0, 1);
  Resolution improves = failed(7);
  improves.left = {{4}};
  improves.solver = "a";
  ladder.end(0, improves);
  ASSERT_TRUE(ladder.is_decided());
  EXPECT_EQ(ladder.take().solver, "a");
}

TEST(Ladder, IsExhaustedAtItsTopWithAllItsEffort) {
  Ladder ladder = three();
  for (std::size_t rung = 0; rung < 3; ++rung) {
    ladder.begin(rung, 1);
    ladder.end(rung, failed(5));
  }
  ASSERT_TRUE(ladder.is_decided());
  const Resolution resolution = ladder.take();
  EXPECT_FALSE(resolution.solved);
  EXPECT_EQ(resolution.solver, "");
  EXPECT_EQ(resolution.effort.searches, 15U);
}

TEST(Ladder, OffersRungsAheadOfNeedInOrderUpToOneThatSolvesIt) {
  Ladder ladder = three();
  EXPECT_EQ(ladder.next_ahead(), 1U);
  ladder.begin(1, 2);
  EXPECT_EQ(ladder.next_ahead(), 2U);
  ladder.end(1, solved("b", 1));
  EXPECT_EQ(ladder.next_ahead(), std::nullopt);
}

TEST(Ladder, OffersARungThatCameToNothingOnlyWhenItIsNeeded) {
  Ladder ladder = three();
  ladder.begin(1, 2);
  ladder.put_off(1);
  EXPECT_EQ(ladder.next_ahead(), 2U);
  ladder.begin(0, 3);
  ladder.end(0, failed(1));
  EXPECT_EQ(ladder.needed(), 1U);
  EXPECT_EQ(ladder.ticket(1), std::nullopt);
}

TEST(Ladder, WithoutRungsIsExhaustedAtOnce) {
  Ladder ladder(std::make_shared<const Subproblem>(), {});
  ASSERT_TRUE(ladder.is_decided());
  EXPECT_FALSE(ladder.take().solved);
}

TEST(Ladder, TellsWhoseAttemptsLedToTheResolution) {
  Ladder ladder = three();
  for (std::size_t rung = 0; rung < 3; ++rung) ladder.begin(rung, rung + 1);
  ladder.end(2, solved("c", 1), {"1-3", "third", 3});
  ladder.end(0, failed(1), {"1-1", "first", 1});
  ladder.end(1, solved("b", 1), {"1-2", "second", 2});
  const auto climbed = ladder.climbed();
  ASSERT_EQ(climbed.size(), 2U) << "what the third has done was not needed";
  EXPECT_EQ(climbed[0].doer.worker, "first");
  EXPECT_FALSE(climbed[0].resolution.solved);
  EXPECT_EQ(climbed[1].doer.task, "1-2");
  EXPECT_EQ(climbed[1].resolution.solver, "b");
}

}  // namespace
}  // namespace accord
