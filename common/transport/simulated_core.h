// What a SimulatedNetwork does: who is on it, what each knows of the others, what is on its way.
// For simulated_network.cpp.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "common/planning/random.h"
#include "common/transport/simulated_network.h"

namespace accord {

class SimulatedCore {
 public:
  using Duration = Bus::Duration;

  SimulatedCore(std::uint64_t seed, const NetworkTimes& times) : times_(times), random_(seed) {}

  EndpointId join(Role role, std::uint32_t protocol, std::size_t capacity);
  void leave(EndpointId id);
  void kill(EndpointId id);
  void set_frozen(EndpointId id, bool frozen);
  void set_cut(EndpointId a, EndpointId b, bool cut);
  void set_faults(const NetworkFaults& faults) { faults_ = faults; }

  Published publish(EndpointId from, EndpointId to, const Message& message);
  std::optional<BusEvent> take(EndpointId id);
  bool wait(EndpointId id, Duration timeout);
  void wake(EndpointId id) { nodes_.at(id).woken = true; }

  Duration now() const { return now_; }
  std::optional<Duration> next() const;
  void advance_to(Duration time);

 private:
  // From one endpoint to another.
  using Way = std::pair<EndpointId, EndpointId>;
  using Lane = std::pair<Way, std::size_t>;  // of one kind of message

  struct Arrived {
    BusEvent event;
    std::optional<Lane> lane;  // of a message that counts against its capacity
  };

  struct Node {
    Role role;
    std::uint32_t protocol;
    std::size_t capacity;
    bool alive = true;
    bool frozen = false;
    bool woken = false;
    std::deque<Arrived> inbox = {};
  };

  // What the first of a way knows of the second.
  struct View {
    bool present = false;
    std::uint64_t changes =
        0;  // of whether it can be heard: what was to follow an earlier one is off
  };

  struct LaneState {
    std::size_t queued = 0;  // published and not yet taken
    Duration last{0};        // when the latest in order arrives
  };

  void at(Duration time, std::function<void()> what);
  bool is_heard(EndpointId listener, EndpointId speaker) const;
  bool is_cut(EndpointId a, EndpointId b) const { return cut_.contains(std::minmax(a, b)); }
  // After a change of whether `speaker` can be heard. `goodbye`: no need to wait for the lease.
  void review(EndpointId listener, EndpointId speaker, bool goodbye = false);
  void review_all(EndpointId about, bool goodbye = false);
  void appear(EndpointId listener, EndpointId speaker);
  void lose(EndpointId listener, EndpointId speaker);

  Published send(EndpointId from, EndpointId to, const Message& message);
  Duration draw_delay() { return draw(times_.least_delay, times_.most_delay); }
  Duration draw(Duration least, Duration most);
  Duration when_through(const Way& way, const Message& message);
  void deliver(const Lane& lane, const Message& message, bool counts);
  std::vector<EndpointId> peers_of(EndpointId id) const;

  NetworkTimes times_;
  NetworkFaults faults_;
  RandomStream random_;
  Duration now_{0};
  std::uint64_t actions_ = 0;
  std::map<std::pair<Duration, std::uint64_t>, std::function<void()>> agenda_;
  std::map<EndpointId, Node> nodes_;
  std::map<Way, View> views_;
  std::map<Lane, LaneState> lanes_;
  std::map<Way, Duration> busy_until_;
  std::set<Way> cut_;
  std::map<Way, std::vector<std::function<void()>>> held_;  // until the link heals
};

}  // namespace accord
