// What a worker has done so far, counted by its loop and read by whoever watches over the process.
// Outlives loops: a worker that joins anew goes on counting. Thread safe.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "common/transport/messages.h"

namespace accord {

class WorkerTally {
 public:
  using Outcome = ResultItem::Outcome;
  static constexpr std::size_t kOutcomes = 4;

  void count(const ResultItem& result) {
    ended_[static_cast<std::size_t>(result.outcome)] += 1;
    seconds_ += result.seconds;
  }
  void set_employed(bool is_employed) { is_employed_ = is_employed; }
  void note_turn() { turned_ = Clock::now().time_since_epoch().count(); }

  // Tasks that ended so, revoked ones included.
  std::uint64_t ended(Outcome outcome) const { return ended_[static_cast<std::size_t>(outcome)]; }
  double seconds() const { return seconds_; }         // of work, of all threads
  bool is_employed() const { return is_employed_; }   // it works for a coordinator
  std::chrono::nanoseconds since_last_turn() const {  // of the loop
    return Clock::now().time_since_epoch() - Clock::duration(turned_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::array<std::atomic<std::uint64_t>, kOutcomes> ended_{};
  std::atomic<double> seconds_ = 0;
  std::atomic<bool> is_employed_ = false;
  std::atomic<Clock::rep> turned_ = Clock::now().time_since_epoch().count();
};

}  // namespace accord
