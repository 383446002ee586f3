// Cancels requests, whoever has submitted them, and tells what becomes of each. Messages may get
// lost and the service may be restarted: whatever has not ended is asked for again.
// Not thread safe.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/fleet/fleet_manager.h"

namespace accord {

class Cancellation {
 public:
  using Clock = FleetManager::Clock;

  // Patience: how long a service may say nothing at all. Requires: the port hears no outcomes of
  // the past (HeardPlans); it outlives this.
  Cancellation(FleetClientPort& port, const std::vector<std::string>& ids,
               const FleetManager::Settings& settings);

  // How a request ended. A plan need not be cancelled: it may have ended otherwise before. A reply
  // in NoAnswer may say that nobody knows it.
  struct End {
    std::string id;
    std::variant<Plan, NoAnswer> how;
  };
  // The next end; waits for it until the timeout ends.
  std::optional<End> next(Clock::duration timeout);

  // Whether next() has something to tell, now or later.
  bool is_waiting() const { return !waiting_.empty() || !ends_.empty(); }

 private:
  struct Waiting {
    Clock::time_point ask_at;
    Clock::duration again;
  };

  void take_news();
  void end(const std::string& id, std::variant<Plan, NoAnswer> how);
  Clock::time_point ask(Clock::time_point now);

  FleetClientPort& port_;
  FleetManager::Settings settings_;
  Clock::time_point heard_;  // anything
  std::map<std::string, Waiting> waiting_;
  std::deque<End> ends_;
};

}  // namespace accord
