#include "coordinator/watchdog.h"

#include <algorithm>

namespace accord {
namespace {

constexpr auto kCancelPoll = std::chrono::milliseconds(20);

}  // namespace

Watchdog::Watchdog(std::optional<double> timeout, const std::atomic<bool>* cancel)
    : cancel_(cancel) {
  if (!timeout && cancel == nullptr) return;
  if (timeout) {
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(*timeout));
  }
  thread_ = std::thread([this] { watch(); });
}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Watchdog::watch() {
  std::unique_lock lock(mutex_);
  while (!done_) {
    if (deadline_ && Clock::now() >= *deadline_) timed_out_ = stop_ = true;
    if (cancel_ != nullptr && *cancel_) stop_ = true;
    if (stop_) return;
    auto until = Clock::now() + std::chrono::hours(1);
    if (cancel_ != nullptr) until = Clock::now() + kCancelPoll;
    if (deadline_) until = std::min(until, *deadline_);
    wake_.wait_until(lock, until, [this] { return done_; });
  }
}

}  // namespace accord
