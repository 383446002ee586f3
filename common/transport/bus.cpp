#include "common/transport/bus.h"

#include <algorithm>

#include "common/transport/message_limits.h"

namespace accord {

bool Bus::is_present(EndpointId peer) const {
  return std::ranges::find(peers_, peer) != peers_.end();
}

Published Bus::publish(EndpointId to, const Message& message) {
  if (sender_of(message) != role_ || message_fault(message)) return Published::kInvalid;
  const bool to_all = to == EndpointId{} && std::holds_alternative<Announcement>(message);
  if (!to_all && !is_present(to)) return Published::kNoPeer;
  const Published outcome = do_publish(to, message);
  if (outcome == Published::kSent) {
    BusCounters::Kind& kind = counters_.kinds[message.index()];
    ++kind.sent;
    kind.sent_bytes += wire_bytes(message);
  }
  if (outcome == Published::kFull) ++counters_.full;
  return outcome;
}

std::optional<BusEvent> Bus::take() {
  while (auto event = do_take()) {
    if (std::holds_alternative<PeerAppeared>(event->what)) {
      peers_.push_back(event->peer);
    } else if (std::holds_alternative<PeerLost>(event->what)) {
      std::erase(peers_, event->peer);
    } else {
      const auto& message = std::get<Message>(event->what);
      if (sender_of(message) == role_ || message_fault(message)) {
        ++counters_.malformed;
        continue;
      }
      BusCounters::Kind& kind = counters_.kinds[message.index()];
      ++kind.received;
      kind.received_bytes += wire_bytes(message);
    }
    return event;
  }
  return std::nullopt;
}

}  // namespace accord
