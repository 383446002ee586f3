// Raises a flag when a deadline passes or a caller cancels.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace accord {

class Watchdog {
 public:
  // timeout: s from now. cancel: may be null; must outlive this.
  Watchdog(std::optional<double> timeout, const std::atomic<bool>* cancel);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  const std::atomic<bool>& stop() const { return stop_; }
  bool timed_out() const { return timed_out_; }

 private:
  using Clock = std::chrono::steady_clock;

  void watch();

  const std::atomic<bool>* cancel_;
  std::optional<Clock::time_point> deadline_;
  std::atomic<bool> stop_{false}, timed_out_{false};
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace accord
