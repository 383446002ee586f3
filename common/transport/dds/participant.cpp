#include "common/transport/dds/participant.h"

#include <fastdds/dds/publisher/qos/PublisherQos.hpp>
#include <fastdds/dds/subscriber/qos/SubscriberQos.hpp>
#include <utility>

#include "common/transport/dds/conversions.h"
#include "common/transport/dds/domain.h"
#include "common/transport/dds/qos.h"
#include "common/transport/message_limits.h"

namespace accord::dds {
namespace {

using namespace eprosima::fastdds::dds;

// Which role sends messages of a kind.
bool is_sent_by(Role role, std::size_t kind) {
  const bool outwards = kind < kAnnouncements;
  return outwards == (role == Role::kCoordinator);
}

template <std::size_t Kind>
Topic* create_topic(DomainParticipant& participant, std::uint32_t protocol) {
  TypeSupport type(new typename Wire<std::variant_alternative_t<Kind, Message>>::Support());
  return add_topic(participant, topic_name(Kind, protocol), type);
}

template <std::size_t... Kinds>
std::array<Topic*, kMessageKinds> create_topics(DomainParticipant& participant,
                                                std::uint32_t protocol,
                                                std::index_sequence<Kinds...>) {
  return {create_topic<Kinds>(participant, protocol)...};
}

}  // namespace

tl::expected<std::unique_ptr<Participant>, std::string> Participant::create(
    const DdsOptions& options, const PeerName& name, PeerBook& book, Signal& signal) {
  std::unique_ptr<Participant> out(new Participant(book, signal));
  const auto joined = join_domain(options, to_user_data(name), &out->on_participant_);
  if (!joined) return tl::unexpected(joined.error());
  out->participant_ = *joined;
  if (!out->add_topics(options.protocol)) return tl::unexpected(std::string("DDS refused a topic"));
  return out;
}

bool Participant::add_topics(std::uint32_t protocol) {
  topics_ = create_topics(*participant_, protocol, std::make_index_sequence<kMessageKinds>());
  return std::ranges::find(topics_, nullptr) == topics_.end();
}

Participant::~Participant() {
  if (participant_ != nullptr) leave_domain(*participant_);
}

bool Participant::add_writers(Role sender, const std::string& partition, Writers& out) {
  PublisherQos qos;
  qos.partition().push_back(partition.c_str());
  out.publisher = participant_->create_publisher(qos);
  if (out.publisher == nullptr) return false;
  for (std::size_t kind = 0; kind < kMessageKinds; ++kind) {
    if (!is_sent_by(sender, kind)) continue;
    out.of_kind[kind] = out.publisher->create_datawriter(
        topics_[kind], writer_qos(kTopics[kind].writer_depth), &on_writer_);
    if (out.of_kind[kind] == nullptr) return false;
  }
  return true;
}

bool Participant::add_readers(Role sender, const std::string& partition, Readers& out) {
  SubscriberQos qos;
  qos.partition().push_back(partition.c_str());
  out.subscriber = participant_->create_subscriber(qos);
  if (out.subscriber == nullptr) return false;
  for (std::size_t kind = 0; kind < kMessageKinds; ++kind) {
    if (!is_sent_by(sender, kind)) continue;
    out.of_kind[kind] = out.subscriber->create_datareader(
        topics_[kind], reader_qos(kTopics[kind].reader_depth), &on_reader_);
    if (out.of_kind[kind] == nullptr) return false;
  }
  return true;
}

void Participant::remove(Writers& writers) {
  if (writers.publisher == nullptr) return;
  for (DataWriter* writer : writers.of_kind) {
    if (writer == nullptr) continue;
    const Guid guid = writer->guid();
    writers.publisher->delete_datawriter(writer);
    book_.forget(guid);
  }
  participant_->delete_publisher(writers.publisher);
  writers = {};
}

}  // namespace accord::dds
