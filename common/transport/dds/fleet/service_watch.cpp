#include "common/transport/dds/fleet/service_watch.h"

#include <algorithm>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>

namespace accord::dds {

using eprosima::fastrtps::rtps::iHandle2GUID;
using eprosima::fastrtps::rtps::ParticipantDiscoveryInfo;

void ServiceWatch::discovered(const GuidPrefix& participant, const std::string& user_data) {
  if (user_data != user_data_) return;
  {
    const std::scoped_lock lock(mutex_);
    entries_[participant].service = true;
  }
  signal_.raise();
}

void ServiceWatch::gone(const GuidPrefix& participant) {
  {
    const std::scoped_lock lock(mutex_);
    entries_.erase(participant);
  }
  signal_.raise();
}

void ServiceWatch::matched(const Guid& ours, const Guid& theirs) {
  {
    const std::scoped_lock lock(mutex_);
    entries_[theirs.guidPrefix].matches.emplace(ours, theirs);
  }
  signal_.raise();
}

void ServiceWatch::unmatched(const Guid& ours, const Guid& theirs) {
  {
    const std::scoped_lock lock(mutex_);
    const auto entry = entries_.find(theirs.guidPrefix);
    if (entry == entries_.end()) return;
    entry->second.matches.erase({ours, theirs});
    if (!entry->second.service && entry->second.matches.empty()) entries_.erase(entry);
  }
  signal_.raise();
}

bool ServiceWatch::is_there() const {
  const std::scoped_lock lock(mutex_);
  return std::ranges::any_of(entries_, [&](const auto& entry) {
    return entry.second.service && entry.second.matches.size() >= pairs_;
  });
}

void ClientListener::on_participant_discovery(eprosima::fastdds::dds::DomainParticipant*,
                                              ParticipantDiscoveryInfo&& info) {
  const auto& participant = info.info.m_guid.guidPrefix;
  switch (info.status) {
    case ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT:
    case ParticipantDiscoveryInfo::CHANGED_QOS_PARTICIPANT: {
      const auto& data = info.info.m_userData;
      watch_.discovered(participant, std::string(data.begin(), data.end()));
      break;
    }
    case ParticipantDiscoveryInfo::REMOVED_PARTICIPANT:
    case ParticipantDiscoveryInfo::DROPPED_PARTICIPANT:
      watch_.gone(participant);
      break;
  }
}

void ClientListener::on_publication_matched(
    eprosima::fastdds::dds::DataWriter* writer,
    const eprosima::fastdds::dds::PublicationMatchedStatus& info) {
  const auto theirs = iHandle2GUID(info.last_subscription_handle);
  info.current_count_change > 0 ? watch_.matched(writer->guid(), theirs)
                                : watch_.unmatched(writer->guid(), theirs);
}

void ClientListener::on_subscription_matched(
    eprosima::fastdds::dds::DataReader* reader,
    const eprosima::fastdds::dds::SubscriptionMatchedStatus& info) {
  const auto theirs = iHandle2GUID(info.last_publication_handle);
  info.current_count_change > 0 ? watch_.matched(reader->guid(), theirs)
                                : watch_.unmatched(reader->guid(), theirs);
}

}  // namespace accord::dds
