// What the coordinator has done so far, noted by its loop and read by whoever watches over the
// process. Thread safe.
#pragma once

#include <chrono>
#include <mutex>

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
  };

  void note(Totals totals) {
    const std::lock_guard lock(mutex_);
    totals_ = std::move(totals);
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
  // Requests are accepted, and somebody is there to work on them.
  bool is_ready() const {
    const std::lock_guard lock(mutex_);
    return totals_.status.accepting && totals_.status.workers > 0;
  }

 private:
  using Clock = std::chrono::steady_clock;

  mutable std::mutex mutex_;
  Totals totals_;
  Clock::time_point turned_ = Clock::now();
};

}  // namespace accord
