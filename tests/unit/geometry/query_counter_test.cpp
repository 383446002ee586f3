#include "common/geometry/query_counter.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

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

}  // namespace
}  // namespace accord
