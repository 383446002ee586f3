// A network inside one thread, on a clock that only its user moves, with faults to order: what
// coordinator and workers are tested on, thousands of clusters a minute. The same seed and the same
// calls give the same run, to the last message.
//
// Without faults it keeps all that bus.h promises. Not thread safe.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "common/transport/bus.h"

namespace accord {

// What happens to messages on their way. Probabilities in [0, 1], drawn for each message.
struct NetworkFaults {
  double drop = 0;       // kSent, but never arrives
  double duplicate = 0;  // arrives twice, the second time on its own delay
  double reorder = 0;    // arrives on its own delay, whatever is before it
};

struct NetworkTimes {
  Bus::Duration least_delay = std::chrono::microseconds(100);  // of a message
  Bus::Duration most_delay = std::chrono::microseconds(300);
  double bytes_per_second = 0;                             // of each link; 0: no limit
  Bus::Duration discovery = std::chrono::milliseconds(5);  // until peers know a newcomer
  Bus::Duration lease = std::chrono::seconds(2);           // until the silent are given up
};

class SimulatedCore;

class SimulatedNetwork {
 public:
  explicit SimulatedNetwork(std::uint64_t seed, const NetworkTimes& times = {});
  ~SimulatedNetwork();
  SimulatedNetwork(const SimulatedNetwork&) = delete;
  SimulatedNetwork& operator=(const SimulatedNetwork&) = delete;

  // A new endpoint. Destroying it is a goodbye. `capacity`: messages of one kind that one peer may
  // have on its way to another, before publish() returns kFull. Waiting on it moves the clock, for
  // all.
  std::unique_ptr<Bus> join(Role role, std::uint32_t protocol = kProtocol,
                            std::size_t capacity = 64);

  Bus::Duration now() const;
  // When something happens next, if anything is on its way.
  std::optional<Bus::Duration> next() const;
  // Lets happen what is due until then. Requires: not before now().
  void advance_to(Bus::Duration time);

  // From now on, for messages published from now on.
  void set_faults(const NetworkFaults& faults);

  // Between two endpoints, both ways. Messages wait for the link to heal, until one end gives the
  // other up.
  void cut(EndpointId a, EndpointId b);
  void heal(EndpointId a, EndpointId b);

  // As kill -9: no goodbye, and its Bus is dead.
  void kill(EndpointId endpoint);

  // As SIGSTOP and SIGCONT to all others: it is silent, and given up when its lease ends. It may
  // take what came before. (Not to run its owner is the user's part.)
  void freeze(EndpointId endpoint);
  void thaw(EndpointId endpoint);

 private:
  std::shared_ptr<SimulatedCore> core_;
};

}  // namespace accord
