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
    Traffic& kind = counters_.kinds[message.index()];
    ++kind.sent;
    kind.sent_bytes += wire_bytes(message);
  }
  if (outcome == Published::kFull) ++counters_.full;
  return outcome;
}

std::optional<BusEvent> Bus::take() {
  if (!ready_.empty()) {
    BusEvent event = std::move(ready_.front());
    ready_.pop_front();
    return event;
  }
  while (auto event = next_event()) {
    if (std::holds_alternative<PeerAppeared>(event->what)) {
      peers_.push_back(event->peer);
      release(event->peer);
    } else if (std::holds_alternative<PeerLost>(event->what)) {
      std::erase(peers_, event->peer);
    } else if (!is_present(event->peer) &&
               !std::holds_alternative<Announcement>(std::get<Message>(event->what))) {
      hold_back(std::move(*event));
      continue;
    }
    return event;
  }
  return std::nullopt;
}

// What the implementation gives, but for messages that are beyond a limit.
std::optional<BusEvent> Bus::next_event() {
  while (auto event = do_take()) {
    const auto* message = std::get_if<Message>(&event->what);
    if (message == nullptr) return event;
    if (sender_of(*message) == role_ || message_fault(*message)) {
      ++counters_.malformed;
      continue;
    }
    Traffic& kind = counters_.kinds[message->index()];
    ++kind.received;
    kind.received_bytes += wire_bytes(*message);
    return event;
  }
  return std::nullopt;
}

void Bus::hold_back(BusEvent event) {
  constexpr std::size_t kMost = 1024;
  if (early_.size() >= kMost) {
    early_.pop_front();
    ++counters_.early;
  }
  early_.push_back(std::move(event));
}

void Bus::release(EndpointId peer) {
  for (BusEvent& event : early_) {
    if (event.peer == peer) ready_.push_back(std::move(event));
  }
  std::erase_if(early_, [&](const BusEvent& event) { return event.peer == peer; });
}

}  // namespace accord
