#include "common/transport/dds/listener.h"

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <string>

namespace accord::dds {

using eprosima::fastrtps::rtps::iHandle2GUID;
using eprosima::fastrtps::rtps::ParticipantDiscoveryInfo;

void ParticipantListener::on_participant_discovery(eprosima::fastdds::dds::DomainParticipant*,
                                                   ParticipantDiscoveryInfo&& info) {
  const GuidPrefix& participant = info.info.m_guid.guidPrefix;
  switch (info.status) {
    case ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT:
    case ParticipantDiscoveryInfo::CHANGED_QOS_PARTICIPANT: {
      const auto& data = info.info.m_userData;
      const auto name = parse_user_data(std::string(data.begin(), data.end()));
      if (name) book_.discovered(participant, *name);
      break;
    }
    case ParticipantDiscoveryInfo::REMOVED_PARTICIPANT:
    case ParticipantDiscoveryInfo::DROPPED_PARTICIPANT:
      book_.gone(participant);
      break;
  }
}

void WriterListener::on_publication_matched(
    eprosima::fastdds::dds::DataWriter* writer,
    const eprosima::fastdds::dds::PublicationMatchedStatus& info) {
  const Guid theirs = iHandle2GUID(info.last_subscription_handle);
  info.current_count_change > 0 ? book_.matched(writer->guid(), theirs)
                                : book_.unmatched(writer->guid(), theirs);
}

void ReaderListener::on_subscription_matched(
    eprosima::fastdds::dds::DataReader* reader,
    const eprosima::fastdds::dds::SubscriptionMatchedStatus& info) {
  const Guid theirs = iHandle2GUID(info.last_publication_handle);
  info.current_count_change > 0 ? book_.matched(reader->guid(), theirs)
                                : book_.unmatched(reader->guid(), theirs);
}

void ReaderListener::on_data_available(eprosima::fastdds::dds::DataReader*) {
  signal_.raise();
}

}  // namespace accord::dds
