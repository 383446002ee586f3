// The first that a command hears of a service, before it shows anything.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>

#include "client/watch/watched_fleet.h"
#include "common/transport/fleet/fleet_port.h"

namespace accord {

// Of the clock that all of client/watch goes by.
WatchTime watch_now();

// All that has come, told to `on_change` where it is a change; forgets what is over.
void take_all(FleetClientPort& port, WatchedFleet& fleet,
              const std::function<void(const WatchedFleet::Change&)>& on_change = {});

// Listens until the fleet is complete, but no longer than it takes a service to say all of it
// again. False: no service has said anything within the patience, or `stop` became true. `on_turn`
// is called some times a second meanwhile.
bool listen_for_first_picture(FleetClientPort& port, WatchedFleet& fleet,
                              std::chrono::nanoseconds patience, const std::atomic<bool>& stop,
                              const std::function<void()>& on_turn = {});

}  // namespace accord
