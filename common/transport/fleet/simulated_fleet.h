// The public topics within one process, for tests: a service that may be killed and come back, any
// number of clients, and faults to order.
//
// What travels is what travels over DDS: whole requests, and news in parts. Without faults all of
// it arrives once, in order. A client that does not take loses the oldest.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

#include "common/transport/fleet/assembling_client.h"
#include "common/transport/fleet/fleet_port.h"

namespace accord {

// How likely it is that a request, or a part of news on its way to one client, ...
struct FleetFaults {
  double drop = 0;       // ... never comes,
  double duplicate = 0;  // ... comes twice,
  double reorder = 0;    // ... is overtaken by up to twenty that come after it.
};

class SimulatedFleetCore;

// Thread safe, and so are its ports as far as different ones are called from different threads.
// What is drawn depends on the seed and on the order in which things are sent. Ports may outlive
// it.
class SimulatedFleet {
 public:
  // patience: of clients with plans that come with a gap.
  explicit SimulatedFleet(std::uint64_t seed,
                          std::chrono::nanoseconds patience = AssemblingClient::kPatience);
  ~SimulatedFleet();

  // `wake` is called while the fleet is locked: it must not call any port. Requires: no service is
  // there.
  std::unique_ptr<FleetServicePort> serve(std::function<void()> wake);
  std::unique_ptr<FleetClientPort> join(HeardPlans plans = HeardPlans::kWhole);

  void set_faults(const FleetFaults& faults);

  // As if its process had died: it is not there any more. Its port says and hears nothing.
  void kill_service();

 private:
  std::shared_ptr<SimulatedFleetCore> core_;
  std::chrono::nanoseconds patience_;
};

}  // namespace accord
