#include "common/transport/simulated_core.h"

#include <algorithm>
#include <cmath>

#include "common/transport/message_limits.h"

namespace accord {
namespace {

// Those that overtake or are overtaken are this many times as late at most.
constexpr int kStraggling = 20;

}  // namespace

// ---- Time ----

void SimulatedCore::at(Duration time, std::function<void()> what) {
  agenda_.emplace(std::pair(time, actions_++), std::move(what));
}

std::optional<SimulatedCore::Duration> SimulatedCore::next() const {
  if (agenda_.empty()) return std::nullopt;
  return agenda_.begin()->first.first;
}

void SimulatedCore::advance_to(Duration time) {
  while (!agenda_.empty() && agenda_.begin()->first.first <= time) {
    auto node = agenda_.extract(agenda_.begin());
    now_ = std::max(now_, node.key().first);
    node.mapped()();
  }
  now_ = std::max(now_, time);
}

bool SimulatedCore::wait(EndpointId id, Duration timeout) {
  Node& node = nodes_.at(id);
  const Duration deadline = now_ + std::max(timeout, Duration::zero());
  while (node.inbox.empty() && !node.woken && now_ < deadline) {
    advance_to(std::min(next().value_or(deadline), deadline));
  }
  node.woken = false;
  return !node.inbox.empty();
}

SimulatedCore::Duration SimulatedCore::draw(Duration least, Duration most) {
  const double span = static_cast<double>((most - least).count());
  return least + Duration(std::llround(random_.uniform() * span));
}

// ---- Who is there ----

EndpointId SimulatedCore::join(Role role, std::uint32_t protocol, std::size_t capacity) {
  EndpointId id;
  while (id.value == 0 || nodes_.contains(id)) id.value = random_.next();
  nodes_.emplace(id, Node{.role = role, .protocol = protocol, .capacity = capacity});
  review_all(id);
  return id;
}

std::vector<EndpointId> SimulatedCore::peers_of(EndpointId id) const {
  const Node& node = nodes_.at(id);
  std::vector<EndpointId> out;
  for (const auto& [other, its] : nodes_) {
    if (its.role != node.role && its.protocol == node.protocol) out.push_back(other);
  }
  return out;
}

bool SimulatedCore::is_heard(EndpointId listener, EndpointId speaker) const {
  const Node& node = nodes_.at(speaker);
  return node.alive && !node.frozen && !is_cut(listener, speaker);
}

void SimulatedCore::review_all(EndpointId about, bool goodbye) {
  for (const EndpointId peer : peers_of(about)) {
    review(peer, about, goodbye);
    review(about, peer);
  }
}

void SimulatedCore::review(EndpointId listener, EndpointId speaker, bool goodbye) {
  View& view = views_[{listener, speaker}];
  const std::uint64_t change = ++view.changes;
  const bool heard = is_heard(listener, speaker);
  if (heard == view.present) return;
  const Duration quick = goodbye && !is_cut(listener, speaker) ? draw_delay() : times_.lease;
  at(now_ + (heard ? times_.discovery : quick), [this, listener, speaker, change, heard] {
    const View& now = views_[{listener, speaker}];
    if (now.changes != change || now.present == heard) return;
    heard ? appear(listener, speaker) : lose(listener, speaker);
  });
}

void SimulatedCore::appear(EndpointId listener, EndpointId speaker) {
  views_[{listener, speaker}].present = true;
  if (!nodes_.at(listener).alive) return;
  nodes_.at(listener).inbox.push_back({{speaker, PeerAppeared{}}, std::nullopt});
}

void SimulatedCore::lose(EndpointId listener, EndpointId speaker) {
  views_[{listener, speaker}].present = false;
  nodes_.at(listener).inbox.push_back({{speaker, PeerLost{}}, std::nullopt});
  // What the listener had sent there and waited for the link is given up, too.
  const Way way{listener, speaker};
  held_.erase(way);
  if (nodes_.at(speaker).alive && !is_cut(listener, speaker)) return;
  for (auto& [lane, state] : lanes_) {
    if (lane.first == way) state.queued = 0;
  }
}

void SimulatedCore::leave(EndpointId id) {
  Node& node = nodes_.at(id);
  const bool was_alive = std::exchange(node.alive, false);
  node.inbox.clear();
  if (was_alive) review_all(id, true);
}

void SimulatedCore::kill(EndpointId id) {
  Node& node = nodes_.at(id);
  node.alive = false;
  node.inbox.clear();
  review_all(id);
}

void SimulatedCore::set_frozen(EndpointId id, bool frozen) {
  nodes_.at(id).frozen = frozen;
  review_all(id);
}

void SimulatedCore::set_cut(EndpointId a, EndpointId b, bool cut) {
  const Way link = std::minmax(a, b);
  cut ? void(cut_.insert(link)) : void(cut_.erase(link));
  review(a, b);
  review(b, a);
  if (cut) return;
  for (const Way& way : {Way{a, b}, Way{b, a}}) {
    const auto held = held_.extract(way);
    if (held.empty()) continue;
    const Duration due = now_ + draw_delay();
    for (const auto& delivery : held.mapped()) at(due, delivery);
  }
}

// ---- Messages ----

Published SimulatedCore::publish(EndpointId from, EndpointId to, const Message& message) {
  const Node& node = nodes_.at(from);
  if (!node.alive) return Published::kClosed;
  if (to != EndpointId{}) {
    if (!views_[{from, to}].present) return Published::kNoPeer;
    return send(from, to, message);
  }
  Published outcome = Published::kNoPeer;
  for (const auto& [other, its] : nodes_) {
    if (its.role == node.role || !its.alive) continue;
    const Published one = send(from, other, message);
    if (outcome != Published::kSent) outcome = one;
  }
  return outcome;
}

// When a message that is published now has gone through: after those before it, at the link's rate.
SimulatedCore::Duration SimulatedCore::when_through(const Way& way, const Message& message) {
  if (times_.bytes_per_second <= 0) return now_;
  Duration& busy = busy_until_[way];
  const double seconds = static_cast<double>(wire_bytes(message)) / times_.bytes_per_second;
  busy = std::max(busy, now_) + Duration(std::llround(seconds * 1e9));
  return busy;
}

Published SimulatedCore::send(EndpointId from, EndpointId to, const Message& message) {
  const Lane lane{{from, to}, message.index()};
  LaneState& state = lanes_[lane];
  if (state.queued >= nodes_.at(from).capacity) return Published::kFull;
  // All are drawn whatever happens, so that one fault more does not change the rest of a run.
  const bool dropped = random_.uniform() < faults_.drop;
  const bool twice = random_.uniform() < faults_.duplicate;
  const bool straggles = random_.uniform() < faults_.reorder;
  const Duration through = when_through(lane.first, message);
  const Duration usual = through + draw_delay();
  const Duration late = through + draw(times_.least_delay, kStraggling * times_.most_delay);
  const Duration again = through + draw(times_.least_delay, kStraggling * times_.most_delay);
  if (!dropped) {
    ++state.queued;
    if (!straggles) state.last = std::max(state.last, usual);
    at(straggles ? late : state.last, [this, lane, message] { deliver(lane, message, true); });
  }
  if (twice) at(again, [this, lane, message] { deliver(lane, message, false); });
  return Published::kSent;
}

void SimulatedCore::deliver(const Lane& lane, const Message& message, bool counts) {
  const auto& [from, to] = lane.first;
  Node& node = nodes_.at(to);
  if (!node.alive) return;
  if (is_cut(from, to)) {
    if (!views_[lane.first].present) return void(lanes_[lane].queued = 0);  // nobody to hold it for
    held_[lane.first].push_back([this, lane, message, counts] { deliver(lane, message, counts); });
    return;
  }
  node.inbox.push_back({{from, message}, counts ? std::optional(lane) : std::nullopt});
}

std::optional<BusEvent> SimulatedCore::take(EndpointId id) {
  Node& node = nodes_.at(id);
  if (node.inbox.empty()) return std::nullopt;
  Arrived next = std::move(node.inbox.front());
  node.inbox.pop_front();
  if (next.lane) {
    std::size_t& queued = lanes_[*next.lane].queued;
    queued -= std::min<std::size_t>(queued, 1);
  }
  return std::move(next.event);
}

}  // namespace accord
