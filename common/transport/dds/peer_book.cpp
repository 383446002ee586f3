#include "common/transport/dds/peer_book.h"

#include <algorithm>

namespace accord::dds {

void PeerBook::discovered(const GuidPrefix& participant, const PeerName& name) {
  const std::scoped_lock lock(mutex_);
  Entry& entry = entries_[participant];
  if (entry.name) return;
  entry.name = name;
  if (!is_peer(name)) return;
  report(Change::Kind::kDiscovered, name.id);
  review(entry);
}

void PeerBook::gone(const GuidPrefix& participant) {
  const std::scoped_lock lock(mutex_);
  const auto entry = entries_.find(participant);
  if (entry == entries_.end()) return;
  entry->second.matches.clear();
  review(entry->second);
  entries_.erase(entry);
}

void PeerBook::matched(const Guid& ours, const Guid& theirs) {
  const std::scoped_lock lock(mutex_);
  Entry& entry = entries_[theirs.guidPrefix];
  entry.matches.emplace(ours, theirs);
  review(entry);
}

void PeerBook::unmatched(const Guid& ours, const Guid& theirs) {
  const std::scoped_lock lock(mutex_);
  const auto entry = entries_.find(theirs.guidPrefix);
  if (entry == entries_.end()) return;
  entry->second.matches.erase({ours, theirs});
  review(entry->second);
  // Matches of whom discovery has not named, or no longer does.
  if (!entry->second.name && entry->second.matches.empty()) entries_.erase(entry);
}

void PeerBook::forget(const Guid& ours) {
  const std::scoped_lock lock(mutex_);
  for (auto& [participant, entry] : entries_) {
    std::erase_if(entry.matches, [&](const auto& pair) { return pair.first == ours; });
    review(entry);
  }
}

bool PeerBook::is_peer(const PeerName& name) const {
  return name.role != own_.role && name.cluster == own_.cluster && name.protocol == own_.protocol;
}

void PeerBook::review(Entry& entry) {
  const bool present = entry.name && is_peer(*entry.name) && entry.matches.size() >= pairs_;
  if (present == entry.present || !entry.name) return;
  entry.present = present;
  report(present ? Change::Kind::kAppeared : Change::Kind::kLost, entry.name->id);
}

void PeerBook::report(Change::Kind kind, EndpointId peer) {
  changes_.push_back({kind, peer});
  signal_.raise();
}

std::optional<PeerBook::Change> PeerBook::next_change() {
  const std::scoped_lock lock(mutex_);
  if (changes_.empty()) return std::nullopt;
  const Change change = changes_.front();
  changes_.pop_front();
  return change;
}

std::optional<EndpointId> PeerBook::id_of(const GuidPrefix& participant) const {
  const std::scoped_lock lock(mutex_);
  const auto entry = entries_.find(participant);
  if (entry == entries_.end() || !entry->second.name) return std::nullopt;
  return entry->second.name->id;
}

bool PeerBook::knows(EndpointId peer) const {
  const std::scoped_lock lock(mutex_);
  return std::ranges::any_of(entries_, [&](const auto& entry) {
    return entry.second.name && entry.second.name->id == peer;
  });
}

}  // namespace accord::dds
