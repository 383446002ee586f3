// The two ends of the public topics: the service's, and a fleet manager's. Two implementations
// behind one contract suite: simulated, with faults to order, and DDS.
//
// Thread safety: one thread, the loop that owns the port, calls everything. Nothing throws but
// std::bad_alloc. Hostile peers: whatever arrives is within the limits of fleet_limits.h; what is
// not is dropped and counted.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/fleet_traffic.h"

namespace accord {

struct FleetCounters {
  std::uint64_t sent = 0;
  std::uint64_t received = 0;
  std::uint64_t malformed = 0;  // received, beyond a limit or incomplete: dropped
  std::uint64_t unsent = 0;     // published, beyond a limit or not taken by the network: dropped
  // By place in kFleetTopicNames: samples, of which a plan is many. Of a service's end over DDS.
  FleetTraffic::Totals topics = {};
};

// The service's end.
class FleetServicePort {
 public:
  virtual ~FleetServicePort() = default;

  // What a fleet manager has asked next, if anything has come.
  virtual std::optional<FleetRequest> take() = 0;
  // To all who listen. Never blocks for more than a few milliseconds, and nobody who does not
  // listen can hold others up: such a one misses something and asks for it again. Late joiners get
  // the latest news; an old plan they ask for.
  virtual void publish(const FleetNews& news) = 0;
  virtual const FleetCounters& counters() const = 0;
};

// What a fleet manager's end hears of plans.
enum class HeardPlans {
  kWhole,        // each as soon as it is complete, from now on
  kOutcomes,     // how each ended, from now on: its robots have names only. For who plans nothing
  kAllOutcomes,  // those of before, too, as far as the service remembers; where a request of old
                 // had the id of one that is on its way, its outcome comes as well
};

// A fleet manager's end.
class FleetClientPort {
 public:
  virtual ~FleetClientPort() = default;

  // False: not sent, since no service is there or it does not take: try again later.
  virtual bool send(const FleetRequest& request) = 0;
  // The next news of whatever request. A plan comes as HeardPlans says.
  virtual std::optional<FleetNews> take() = 0;
  // Waits until take() may give something. May return early.
  virtual void wait(std::chrono::nanoseconds timeout) = 0;
  // Whether a service is present.
  virtual bool has_service() const = 0;
  virtual const FleetCounters& counters() const = 0;
};

}  // namespace accord
