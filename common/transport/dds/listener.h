// Hears what Fast DDS's threads have to say and passes it on: changes to the peer book, everything
// else as a signal. Does nothing else: to create or delete anything in a callback is a deadlock.
#pragma once

#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>

#include "common/transport/dds/peer_book.h"
#include "common/transport/dds/signal.h"

namespace accord::dds {

// Of a participant; must be given StatusMask::none(), else it hears in the readers' place.
class ParticipantListener final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  explicit ParticipantListener(PeerBook& book) : book_(book) {}
  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;

 private:
  PeerBook& book_;
};

class WriterListener final : public eprosima::fastdds::dds::DataWriterListener {
 public:
  explicit WriterListener(PeerBook& book) : book_(book) {}
  void on_publication_matched(
      eprosima::fastdds::dds::DataWriter* writer,
      const eprosima::fastdds::dds::PublicationMatchedStatus& info) override;

 private:
  PeerBook& book_;
};

class ReaderListener final : public eprosima::fastdds::dds::DataReaderListener {
 public:
  ReaderListener(PeerBook& book, Signal& signal) : book_(book), signal_(signal) {}
  void on_subscription_matched(
      eprosima::fastdds::dds::DataReader* reader,
      const eprosima::fastdds::dds::SubscriptionMatchedStatus& info) override;
  void on_data_available(eprosima::fastdds::dds::DataReader* reader) override;

 private:
  PeerBook& book_;
  Signal& signal_;
};

}  // namespace accord::dds
