// What a worker has done so far, counted by its loop and read by whoever watches over the process.
// Outlives loops: a worker that joins anew goes on counting. Thread safe.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "common/planning/attempt_tally.h"
#include "common/runtime/time_histogram.h"
#include "common/transport/bus.h"

namespace accord {

class WorkerTally {
 public:
  using Outcome = ResultItem::Outcome;
  static constexpr std::size_t kOutcomes = 4;
  // The loop turns ten times a second, however busy the worker is: its tasks have their own
  // threads.
  static constexpr std::chrono::seconds kHangs{10};

  // How a turn of the loop has left things.
  struct Load {
    std::size_t running = 0;   // tasks
    std::size_t waiting = 0;   // tasks
    bool is_employed = false;  // it works for a coordinator
    bool is_leaving = false;   // it takes no more tasks
    BusCounters bus;           // of the present bus
  };
  struct Totals {
    std::array<std::uint64_t, kOutcomes> ended{};  // tasks, by Outcome, revoked ones included
    std::map<std::string, TimeHistogram> solving;  // of those done: by the last solver tried
    AttemptTally::Totals attempts;
    double busy_seconds = 0;  // of work, of all threads
    Load load;                // with what former buses counted
  };

  // A task ended. `levels`: that were tried on it.
  void count(const ResultItem& result, const std::vector<TriedLevel>& levels) {
    attempts_.count(levels);
    const std::lock_guard lock(mutex_);
    ++totals_.ended.at(static_cast<std::size_t>(result.outcome));
    if (result.outcome != Outcome::kDone || levels.empty()) return;
    totals_.solving[counted_solver(levels.back().solver)].add(result.seconds);
  }
  void note_turn(const Load& load) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    const std::chrono::duration<double> time = now - turned_;
    totals_.busy_seconds += time.count() * static_cast<double>(totals_.load.running);
    totals_.load = load;
    turned_ = now;
  }
  // From now on another bus is spoken of, which counts from 0 on.
  void note_new_bus() {
    const std::lock_guard lock(mutex_);
    former_buses_ += std::exchange(totals_.load, {}).bus;
  }

  Totals totals() const {
    const std::lock_guard lock(mutex_);
    Totals out = totals_;
    out.attempts = attempts_.totals();
    out.load.bus += former_buses_;
    return out;
  }
  std::chrono::nanoseconds since_last_turn() const {  // of the loop
    const std::lock_guard lock(mutex_);
    return Clock::now() - turned_;
  }
  // Its loop turns.
  bool is_alive() const { return since_last_turn() < kHangs; }
  // It would take a task that comes now.
  bool is_ready() const {
    if (!is_alive()) return false;
    const std::lock_guard lock(mutex_);
    return totals_.load.is_employed && !totals_.load.is_leaving;
  }

 private:
  using Clock = std::chrono::steady_clock;

  AttemptTally attempts_;
  mutable std::mutex mutex_;
  Totals totals_;  // but for attempts, and with the present bus alone
  BusCounters former_buses_;
  Clock::time_point turned_ = Clock::now();
};

}  // namespace accord
