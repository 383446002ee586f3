// Signals that ask a service to end in order: SIGTERM, SIGINT and SIGHUP.
#pragma once

#include <csignal>

#include <functional>
#include <mutex>
#include <thread>

namespace accord {

// Takes them on a thread of its own, so that what is done about them may lock and log. Create it
// before any other thread: threads inherit that they leave these signals alone. One at a time.
class EndingSignals {
 public:
  EndingSignals();
  ~EndingSignals();
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;

  // What to do when the first one comes, from the other thread; at once where it has come already.
  // Once this returns, what was set before is not called any more. nullptr: nothing.
  void set(std::function<void()> action);

 private:
  void listen();

  sigset_t signals_;
  std::mutex mutex_;
  bool has_come_ = false;
  bool quit_ = false;
  std::function<void()> action_;
  std::thread thread_;  // last
};

}  // namespace accord
