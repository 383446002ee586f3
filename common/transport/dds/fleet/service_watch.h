// Whether a service is there, as a client finds out: from what discovery says of participants, and
// from pairs of readers and writers that match. Others may listen to requests, too; only who says
// to be the service is one.
#pragma once

#include <fastdds/rtps/common/Guid.h>

#include <cstddef>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "common/transport/dds/signal.h"

namespace accord::dds {

// Thread safe: Fast DDS's threads report, the loop asks. Every change raises the signal.
class ServiceWatch {
 public:
  using Guid = eprosima::fastrtps::rtps::GUID_t;
  using GuidPrefix = eprosima::fastrtps::rtps::GuidPrefix_t;

  // A service says `user_data`, and is there when `pairs` pairs match.
  ServiceWatch(std::string user_data, std::size_t pairs, Signal& signal)
      : user_data_(std::move(user_data)), pairs_(pairs), signal_(signal) {}

  void discovered(const GuidPrefix& participant, const std::string& user_data);
  void gone(const GuidPrefix& participant);
  void matched(const Guid& ours, const Guid& theirs);
  void unmatched(const Guid& ours, const Guid& theirs);

  bool is_there() const;

 private:
  struct Entry {
    bool service = false;
    std::set<std::pair<Guid, Guid>> matches = {};
  };

  const std::string user_data_;
  const std::size_t pairs_;
  Signal& signal_;
  mutable std::mutex mutex_;
  std::map<GuidPrefix, Entry> entries_;
};

// Hears for a client and passes on. Does nothing else: to create or delete anything in a callback
// is a deadlock.
class ClientListener final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  ClientListener(ServiceWatch& watch, Signal& signal) : watch_(watch), signal_(signal) {}

  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
  void on_publication_matched(
      eprosima::fastdds::dds::DataWriter* writer,
      const eprosima::fastdds::dds::PublicationMatchedStatus& info) override;
  void on_subscription_matched(
      eprosima::fastdds::dds::DataReader* reader,
      const eprosima::fastdds::dds::SubscriptionMatchedStatus& info) override;
  void on_data_available(eprosima::fastdds::dds::DataReader*) override { signal_.raise(); }

 private:
  ServiceWatch& watch_;
  Signal& signal_;
};

}  // namespace accord::dds
