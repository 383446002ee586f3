// Who is there, worked out from what discovery reports: participants that come and go, and pairs of
// our and their readers and writers that match.
#pragma once

#include <fastdds/rtps/common/Guid.h>

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "common/transport/dds/peer_name.h"
#include "common/transport/dds/signal.h"

namespace accord::dds {

using Guid = eprosima::fastrtps::rtps::GUID_t;
using GuidPrefix = eprosima::fastrtps::rtps::GuidPrefix_t;

// Thread safe: Fast DDS's threads report, the loop asks.
class PeerBook {
 public:
  struct Change {
    enum class Kind {
      kDiscovered,  // a peer's participant is known; nothing can be sent yet
      kAppeared,    // all of its readers and writers match ours
      kLost,        // not all of them do any more
    };
    Kind kind;
    EndpointId peer;
  };

  // A peer is whoever has another role than `own` and the same cluster and protocol. It is present
  // when `pairs` pairs match.
  PeerBook(PeerName own, std::size_t pairs, Signal& signal)
      : own_(std::move(own)), pairs_(pairs), signal_(signal) {}

  void discovered(const GuidPrefix& participant, const PeerName& name);
  void gone(const GuidPrefix& participant);
  void matched(const Guid& ours, const Guid& theirs);
  void unmatched(const Guid& ours, const Guid& theirs);
  // One of our own was deleted: Fast DDS does not say that its pairs are no more.
  void forget(const Guid& ours);

  std::optional<Change> next_change();
  // Of whatever cluster and protocol; nullopt where its participant is not known.
  std::optional<EndpointId> id_of(const GuidPrefix& participant) const;
  bool knows(EndpointId peer) const;

 private:
  struct Entry {
    std::optional<PeerName> name = {};
    std::set<std::pair<Guid, Guid>> matches = {};
    bool present = false;
  };

  bool is_peer(const PeerName& name) const;
  void review(Entry& entry);
  void report(Change::Kind kind, EndpointId peer);

  const PeerName own_;
  const std::size_t pairs_;
  Signal& signal_;
  mutable std::mutex mutex_;
  std::map<GuidPrefix, Entry> entries_;
  std::deque<Change> changes_;
};

}  // namespace accord::dds
