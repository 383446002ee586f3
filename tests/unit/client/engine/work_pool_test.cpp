#include "client/engine/work_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <set>
#include <thread>
#include <vector>

namespace accord {
namespace {

class WorkPoolOf : public testing::TestWithParam<unsigned> {};

TEST_P(WorkPoolOf, CarriesOutEachJobOnce) {
  WorkPool pool(GetParam());
  for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 1000U}) {
    std::vector<std::atomic<int>> times(count);
    pool.run(count, [&](std::size_t i) { ++times[i]; });
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(times[i], 1) << i << " of " << count;
  }
}

TEST_P(WorkPoolOf, HasFinishedAllJobsWhenItReturns) {
  WorkPool pool(GetParam());
  for (int round = 0; round < 2000; ++round) {
    std::vector<int> done(5);  // plain: run() itself has to order what the jobs wrote before this
    pool.run(done.size(), [&](std::size_t i) { done[i] = round; });
    ASSERT_EQ(done, std::vector<int>(5, round));
  }
}

TEST_P(WorkPoolOf, HandsTheFirstFailureToTheCallerAndGoesOnBeingOfUse) {
  WorkPool pool(GetParam());
  for (int round = 0; round < 200; ++round) {
    const auto fail = [](std::size_t) { throw std::bad_alloc(); };
    EXPECT_THROW(pool.run(7, fail), std::bad_alloc);
    std::atomic<int> times = 0;
    pool.run(7, [&](std::size_t) { ++times; });
    ASSERT_EQ(times, 7);
  }
}

TEST_P(WorkPoolOf, CanBeTakenDownWithoutEverHavingRun) {
  const WorkPool pool(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Threads, WorkPoolOf, testing::Values(1U, 2U, 3U, 16U));

TEST(WorkPool, OfOneThreadIsTheCallersOwn) {
  WorkPool pool(1);
  pool.run(3, [caller = std::this_thread::get_id()](std::size_t) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
  });
}

TEST(WorkPool, WorksOnSeveralJobsAtOnce) {
  // Each of three jobs waits for the other two: with fewer than three threads this would hang.
  WorkPool pool(3);
  std::atomic<int> here = 0;
  pool.run(3, [&](std::size_t) {
    ++here;
    while (here < 3) std::this_thread::yield();
  });
  EXPECT_EQ(here, 3);
}

}  // namespace
}  // namespace accord
