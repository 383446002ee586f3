#include "coordinator/watchdog.h"

#include <gtest/gtest.h>

namespace accord {
namespace {

using std::chrono::steady_clock;

// Waits until the watchdog barks, but not for ever.
bool barks(const Watchdog& watchdog) {
  const auto limit = steady_clock::now() + std::chrono::seconds(20);
  while (!watchdog.stop() && steady_clock::now() < limit) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return watchdog.stop();
}

TEST(Watchdog, BarksWhenTheDeadlinePasses) {
  const auto begin = steady_clock::now();
  const Watchdog watchdog(0.05, nullptr);
  EXPECT_TRUE(barks(watchdog));
  EXPECT_TRUE(watchdog.timed_out());
  EXPECT_GE(steady_clock::now() - begin, std::chrono::milliseconds(50)) << "not before it does";
}

TEST(Watchdog, BarksWhenTheCallerCancels) {
  std::atomic<bool> cancel = false;
  const Watchdog watchdog(std::nullopt, &cancel);
  EXPECT_FALSE(watchdog.stop());
  cancel = true;
  EXPECT_TRUE(barks(watchdog));
  EXPECT_FALSE(watchdog.timed_out()) << "who cancels has not run out of time";
}

TEST(Watchdog, BarksAtACancellationLongBeforeTheDeadline) {
  std::atomic<bool> cancel = true;
  const Watchdog watchdog(1e6, &cancel);
  EXPECT_TRUE(barks(watchdog));
  EXPECT_FALSE(watchdog.timed_out());
}

TEST(Watchdog, BarksAtADeadlineThatNobodyCancels) {
  std::atomic<bool> cancel = false;
  const Watchdog watchdog(0.01, &cancel);
  EXPECT_TRUE(barks(watchdog));
  EXPECT_TRUE(watchdog.timed_out());
}

TEST(Watchdog, IsQuietWithNothingToWatch) {
  const Watchdog watchdog(std::nullopt, nullptr);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(watchdog.stop());
  EXPECT_FALSE(watchdog.timed_out());
}

TEST(Watchdog, DoesNotKeepTheCallerWaitingForTheDeadline) {
  const auto begin = steady_clock::now();
  { const Watchdog watchdog(1e6, nullptr); }
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(20));
}

}  // namespace
}  // namespace accord
