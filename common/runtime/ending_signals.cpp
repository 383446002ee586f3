#include "common/runtime/ending_signals.h"

#include <utility>

namespace accord {

EndingSignals::EndingSignals() {
  sigemptyset(&signals_);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals_, signal);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  thread_ = std::thread([this] { listen(); });
}

EndingSignals::~EndingSignals() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    action_ = nullptr;
  }
  pthread_kill(thread_.native_handle(), SIGTERM);
  thread_.join();
}

void EndingSignals::listen() {
  while (true) {
    int signal = 0;
    sigwait(&signals_, &signal);
    const std::lock_guard lock(mutex_);
    if (quit_) return;
    if (std::exchange(has_come_, true)) continue;
    if (action_) action_();
  }
}

void EndingSignals::set(std::function<void()> action) {
  const std::lock_guard lock(mutex_);
  action_ = std::move(action);
  if (has_come_ && action_) action_();
}

}  // namespace accord
