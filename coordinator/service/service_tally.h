// What the coordinator has done so far, noted by its loop and read by whoever watches over the
// process. Thread safe.
#pragma once

#include <chrono>
#include <mutex>
#include <utility>

#include "common/planning/attempt_tally.h"
#include "common/transport/bus.h"
#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/fleet_port.h"
#include "coordinator/dispatch/task_board.h"
#include "coordinator/service/request_desk.h"

namespace accord {

class ServiceTally {
 public:
  struct Totals {
    TaskBoard::Counters tasks;
    RequestDesk::Counters requests;
    BusCounters bus;
    FleetCounters fleet;
    ServiceStatus status;
    std::size_t unfinished_tasks = 0;
    AttemptTally::Totals attempts;
    TaskBoard::Load board;
    RequestDesk::Load desk;
  };
  // The loop turns ten times a second, however much is being planned: that has its own threads.
  static constexpr std::chrono::seconds kHangs{10};

  void note(Totals totals) {
    const std::lock_guard lock(mutex_);
    totals_ = std::move(totals);
    has_begun_ = true;
    turned_ = Clock::now();
  }
  // The loop is at work, though it has not come to its end: it reads the journal.
  void note_turn() {
    const std::lock_guard lock(mutex_);
    turned_ = Clock::now();
  }

  Totals totals() const {
    const std::lock_guard lock(mutex_);
    return totals_;
  }
  std::chrono::nanoseconds since_last_turn() const {  // of the loop
    const std::lock_guard lock(mutex_);
    return Clock::now() - turned_;
  }
  // Its loop turns.
  bool is_alive() const { return since_last_turn() < kHangs; }
  // It would accept a request that comes now, and somebody is there to work on it.
  bool is_ready() const {
    if (!is_alive()) return false;
    const std::lock_guard lock(mutex_);
    return has_begun_ && totals_.status.accepting && totals_.desk.takes_writes &&
           totals_.board.threads > 0;
  }

 private:
  using Clock = std::chrono::steady_clock;

  mutable std::mutex mutex_;
  Totals totals_;
  bool has_begun_ = false;  // there are totals
  Clock::time_point turned_ = Clock::now();
};

}  // namespace accord
