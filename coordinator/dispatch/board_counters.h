// What a task board counts of what it does, for whoever watches over the service.
// A plain value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/runtime/time_histogram.h"

namespace accord {

// Why a task that a worker had is given out anew. The first two: its lease was lost.
enum class Reassigned : std::uint8_t {
  kWorkerLost,  // the worker died or fell silent
  kUnheard,     // the worker does not name it any more: it or its result got lost on its way
  kHandedBack,  // the worker is leaving
  kFailed,      // the worker ran into trouble of its own
  kRefused,     // the worker cannot read it, or does not take as much
  kDistrusted,  // what the worker returned, of this task or another, does not hold
};
inline constexpr std::size_t kReassignedKinds = 6;

struct BoardCounters {
  // Tasks. Each that was added is done, quarantined, refused or cancelled; once but for those whose
  // result does not hold, which are done again.
  std::uint64_t added = 0;
  std::uint64_t assigned = 0;
  std::uint64_t done = 0;
  std::uint64_t quarantined = 0;
  std::uint64_t refused = 0;    // by all workers that were asked
  std::uint64_t cancelled = 0;  // nobody needs it any more
  std::uint64_t put_off = 0;    // ahead of need, and made way
  std::array<std::uint64_t, kReassignedKinds> reassigned_for{};
  TimeHistogram waited;  // from when a task could be given out until it was; each time anew

  // Results that were dropped.
  std::uint64_t late = 0;       // of an assignment that was over: of a worker that was given up
  std::uint64_t duplicate = 0;  // that had come already
  std::uint64_t moot = 0;       // of a task that had been taken back from its worker meanwhile,
                                // since nobody needs it, or not yet

  // Workers.
  std::uint64_t workers_gone = 0;        // DDS says that they are not there any more
  std::uint64_t workers_silent = 0;      // silent for longer than their lease
  std::uint64_t workers_left = 0;        // in order
  std::uint64_t workers_refused = 0;     // of another protocol
  std::uint64_t workers_distrusted = 0;  // of which a result did not hold
  // s, of all their threads, as their heartbeats tell: all there were, and those at work.
  double thread_seconds = 0;
  double busy_seconds = 0;
  double solving_seconds = 0;  // of the results that were taken, by the workers' clocks

  std::uint64_t& reassigned_since(Reassigned why) {
    return reassigned_for.at(static_cast<std::size_t>(why));
  }
  std::uint64_t reassigned(Reassigned why) const {
    return reassigned_for.at(static_cast<std::size_t>(why));
  }
  std::uint64_t reassigned() const {
    std::uint64_t total = 0;
    for (const std::uint64_t count : reassigned_for) total += count;
    return total;
  }
  std::uint64_t workers_lost() const { return workers_gone + workers_silent; }
};

}  // namespace accord
