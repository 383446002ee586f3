// Hears what Fast DDS's threads have to say of a domain, and notes it. Does nothing else: to create
// or delete anything in a callback is a deadlock.
#pragma once

#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>

#include "common/transport/dds/survey/survey_book.h"

namespace accord::dds {

class SurveyListener final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  SurveyListener(SurveyBook& book, Signal& signal) : book_(book), signal_(signal) {}

  void on_participant_discovery(
      eprosima::fastdds::dds::DomainParticipant*,
      eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override {
    using Info = eprosima::fastrtps::rtps::ParticipantDiscoveryInfo;
    const bool is_gone =
        info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT;
    is_gone ? book_.gone(info.info.m_guid.guidPrefix) : book_.discovered(info.info);
  }
  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant*,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override {
    if (info.status != eprosima::fastrtps::rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) return;
    book_.has_endpoint(info.info.guid(), info.info.topicName().to_string(),
                       info.info.m_qos.m_partition);
  }
  void on_subscriber_discovery(eprosima::fastdds::dds::DomainParticipant*,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override {
    if (info.status != eprosima::fastrtps::rtps::ReaderDiscoveryInfo::DISCOVERED_READER) return;
    book_.has_endpoint(info.info.guid(), info.info.topicName().to_string(),
                       info.info.m_qos.m_partition);
  }
  void on_subscription_matched(
      eprosima::fastdds::dds::DataReader*,
      const eprosima::fastdds::dds::SubscriptionMatchedStatus& info) override {
    book_.matched(eprosima::fastrtps::rtps::iHandle2GUID(info.last_publication_handle),
                  info.current_count_change);
  }
  void on_data_available(eprosima::fastdds::dds::DataReader*) override { signal_.raise(); }

 private:
  SurveyBook& book_;
  Signal& signal_;
};

}  // namespace accord::dds
