#include "common/geometry/query_counter.h"

#include <gtest/gtest.h>

#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "common/geometry/distance_tally.h"
#include "common/geometry/tolerances.h"
#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

void count_in_threads(QueryCounter& counter, int threads, int times) {
  std::vector<std::thread> pool;
  for (int i = 0; i < threads; ++i) {
    pool.emplace_back([&] {
      for (int k = 0; k < times; ++k) counter.add(3);
    });
  }
  for (std::thread& thread : pool) thread.join();
}

TEST(QueryCounter, LosesNothingAmongThreads) {
  QueryCounter counter;
  counter.add(1);
  count_in_threads(counter, 8, 10000);
  EXPECT_EQ(counter.total(), 1U + 3U * 8U * 10000U);
}

TEST(QueryCounter, LosesNothingWithMoreThreadsThanSlots) {
  QueryCounter counter;
  count_in_threads(counter, 100, 2000);
  count_in_threads(counter, 100, 2000);
  EXPECT_EQ(counter.total(), 2 * 3U * 100U * 2000U);
}

TEST(SeparateCost, IsWhatItsThreadCountsWhileItLivesOnWhateverCounter) {
  QueryCounter one, other;
  one.add(5);
  const SeparateCost cost;
  one.add(1);
  other.add(2);
  std::jthread([&] { one.add(100); }).join();
  EXPECT_EQ(cost.so_far(), 3U);
}

TEST(SeparateCost, IsNobodyElsesToo) {
  QueryCounter counter;
  const SeparateCost outer;
  counter.add(1);
  {
    const SeparateCost inner;
    counter.add(10);
    EXPECT_EQ(inner.so_far(), 10U);
  }
  counter.add(2);
  EXPECT_EQ(outer.so_far(), 3U);
  EXPECT_EQ(counter.total(), 13U);
}

TEST(DistanceTally, TellsTheWorldOnceWhenItGoes) {
  const CollisionWorld world(test_scenes::SceneBuilder(true).build(), kPlanningMargin);
  {
    std::optional<DistanceTally> first(world);
    first->add(3);
    DistanceTally second(std::move(*first));
    second.add(4);
    first.reset();
    EXPECT_EQ(world.distance_queries(), 0U);
  }
  EXPECT_EQ(world.distance_queries(), 7U);
}

}  // namespace
}  // namespace accord
