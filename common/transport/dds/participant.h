// A DDS participant with the topics of the bus, and what it is asked for: writers and readers of
// one kind of message in one partition.
#pragma once

#include <array>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "common/transport/dds/listener.h"
#include "common/transport/dds/peer_book.h"
#include "common/transport/dds/topics.h"
#include "common/transport/dds_options.h"

namespace accord::dds {

using eprosima::fastdds::dds::DataReader;
using eprosima::fastdds::dds::DataWriter;
using eprosima::fastdds::dds::DomainParticipant;
using eprosima::fastdds::dds::Publisher;
using eprosima::fastdds::dds::Subscriber;
using eprosima::fastdds::dds::Topic;

// One of each kind that a role sends, or hears. Others are null.
struct Writers {
  Publisher* publisher = nullptr;
  std::array<DataWriter*, kMessageKinds> of_kind{};
};
struct Readers {
  Subscriber* subscriber = nullptr;
  std::array<DataReader*, kMessageKinds> of_kind{};
};

// Not thread safe. Calls back, through the listeners, from Fast DDS's threads.
class Participant {
 public:
  // Requires: sound options. `book` and `signal` outlive it.
  static tl::expected<std::unique_ptr<Participant>, std::string> create(const DdsOptions& options,
                                                                        const PeerName& name,
                                                                        PeerBook& book,
                                                                        Signal& signal);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  // Of all kinds that `sender` sends. False where Fast DDS refuses.
  bool add_writers(Role sender, const std::string& partition, Writers& out);
  bool add_readers(Role sender, const std::string& partition, Readers& out);
  void remove(Writers& writers);

 private:
  Participant(PeerBook& book, Signal& signal)
      : book_(book), on_participant_(book), on_writer_(book), on_reader_(book, signal) {}

  bool add_topics(std::uint32_t protocol);

  PeerBook& book_;
  ParticipantListener on_participant_;
  WriterListener on_writer_;
  ReaderListener on_reader_;
  DomainParticipant* participant_ = nullptr;
  std::array<Topic*, kMessageKinds> topics_{};
};

}  // namespace accord::dds
