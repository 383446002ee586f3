// Wakes the loop when something has come.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace accord::dds {

// Thread safe.
class Signal {
 public:
  void raise() {
    {
      const std::scoped_lock lock(mutex_);
      raised_ = true;
    }
    wake_.notify_one();
  }

  // Whether it was raised since the last wait, or has been before the timeout ended. One waiter.
  bool wait(std::chrono::nanoseconds timeout) {
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, timeout, [this] { return raised_; });
    return std::exchange(raised_, false);
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool raised_ = false;
};

}  // namespace accord::dds
