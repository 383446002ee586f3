// How coordinator and workers reach each other: typed publish and take. Two implementations:
// SimulatedNetwork, in one process on a clock of its own and with faults to order, and DDS.
//
// What holds as long as a peer stays present (from its PeerAppeared to its PeerLost):
//   * what is published to it and kSent arrives once, and messages of one kind in order; messages
//   of
//     different kinds may overtake each other, and a message may come before PeerAppeared;
//   * nothing that is meant for others arrives here.
// What was kSent to a peer that is lost may have arrived or not. A peer that was lost may come back
// under the same id (a link was cut, a process was stopped): it appears again.
//
// Thread safety: one thread, the loop that owns the state, calls everything but wake(), which any
// thread may call. Nothing throws but std::bad_alloc. Destruction says goodbye: peers lose this
// endpoint at once.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <variant>
#include <vector>

#include "common/transport/endpoint_id.h"
#include "common/transport/messages.h"
#include "common/transport/traffic.h"

namespace accord {

// What became of a message.
enum class Published {
  kSent,
  kFull,    // not sent: too much is on its way to that peer. Nothing says when there is room again;
            // try later, after a few milliseconds
  kNoPeer,  // not sent: nobody of that id is present
  kInvalid,  // not sent: beyond a limit (message_limits.h), or not for this role to send
  kClosed,   // not sent: this endpoint is dead (only in simulations)
};

struct PeerAppeared {};
struct PeerLost {};

struct BusEvent {
  EndpointId peer;
  std::variant<PeerAppeared, PeerLost, Message> what;
};

// Counted since the beginning; by Message's index().
struct BusCounters {
  std::array<Traffic, kMessageKinds> kinds;
  std::uint64_t full = 0;       // times that publish() returned kFull
  std::uint64_t malformed = 0;  // received, beyond a limit: dropped
  std::uint64_t early = 0;      // received from peers that were not present, too many to hold back:
                                // dropped
  std::uint64_t foreign = 0;    // received, not meant for this endpoint or not from whom it claims
                                // to be: dropped

  BusCounters& operator+=(const BusCounters& other) {
    for (std::size_t kind = 0; kind < kMessageKinds; ++kind) kinds[kind] += other.kinds[kind];
    full += other.full;
    malformed += other.malformed;
    early += other.early;
    foreign += other.foreign;
    return *this;
  }
};

class Bus {
 public:
  using Duration = std::chrono::nanoseconds;

  virtual ~Bus() = default;
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  EndpointId self() const { return self_; }
  Role role() const { return role_; }

  // Never blocks for more than a few milliseconds. An Announcement may go to EndpointId{0}: to
  // every coordinator there is, present or not.
  Published publish(EndpointId to, const Message& message);

  // The next event, if one has come.
  std::optional<BusEvent> take();

  // Whether take() may give something: waits for it until the timeout ends, or wake() is called.
  // May return true for nothing.
  bool wait_for_event(Duration timeout) { return !ready_.empty() || do_wait(timeout); }

  // Ends a wait_for_event() at once, the present one or the next.
  void wake() { do_wake(); }

  // Those present, in no order. Changes with the events that take() gives, not before.
  const std::vector<EndpointId>& peers() const { return peers_; }
  bool is_present(EndpointId peer) const;

  const BusCounters& counters() const { return counters_; }

 protected:
  Bus(EndpointId self, Role role) : self_(self), role_(role) {}

  BusCounters& mutable_counters() { return counters_; }

 private:
  virtual Published do_publish(EndpointId to, const Message& message) = 0;
  virtual std::optional<BusEvent> do_take() = 0;
  virtual bool do_wait(Duration timeout) = 0;
  virtual void do_wake() = 0;

  std::optional<BusEvent> next_event();
  void hold_back(BusEvent event);
  void release(EndpointId peer);

  EndpointId self_;
  Role role_;
  std::deque<BusEvent> early_;  // of peers that are not present
  std::deque<BusEvent> ready_;  // of one that has appeared
  std::vector<EndpointId> peers_;
  BusCounters counters_;
};

}  // namespace accord
