// A DDS participant on the public topics of a cluster.
#pragma once

#include <cstdint>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "common/transport/dds/domain.h"
#include "common/transport/dds/fleet/conversions.h"
#include "common/transport/dds/fleet/topics.h"
#include "common/transport/dds/qos.h"
#include "common/transport/dds_options.h"
#include "common/transport/fleet/fleet_traffic.h"

namespace accord::dds {

// Not thread safe. Listeners are called from Fast DDS's threads, and outlive it.
class FleetParticipant {
 public:
  // In the partition of the cluster, or one of its robots'. `refused` counts samples that made no
  // sense, on the thread that takes. Requires: sound options.
  static tl::expected<std::unique_ptr<FleetParticipant>, std::string> create(
      const DdsOptions& options, const std::string& partition, const char* role,
      eprosima::fastdds::dds::DomainParticipantListener* listener, std::uint64_t* refused);
  ~FleetParticipant() {
    if (participant_ != nullptr) leave_domain(*participant_);
  }
  FleetParticipant(const FleetParticipant&) = delete;
  FleetParticipant& operator=(const FleetParticipant&) = delete;

  // Of the topic of such values. Null where Fast DDS refuses.
  template <typename Value>
  eprosima::fastdds::dds::DataWriter* add_writer(
      eprosima::fastdds::dds::DataWriterListener* listener) {
    constexpr const FleetTopic& kTopic = kFleetTopic<Value>;
    auto* topic = add_topic_of<Value>();
    if (topic == nullptr) return nullptr;
    return publisher_->create_datawriter(topic,
                                         kTopic.kind == FleetTopic::Kind::kRequest
                                             ? writer_qos(kTopic.writer_depth)
                                             : latest_writer_qos(kTopic.writer_depth),
                                         listener);
  }
  // late: whether it gets the writer's history, where this is news.
  template <typename Value>
  eprosima::fastdds::dds::DataReader* add_reader(
      eprosima::fastdds::dds::DataReaderListener* listener, bool late = kFleetTopic<Value>.late) {
    constexpr const FleetTopic& kTopic = kFleetTopic<Value>;
    auto* topic = add_topic_of<Value>();
    if (topic == nullptr) return nullptr;
    return subscriber_->create_datareader(topic,
                                          kTopic.kind == FleetTopic::Kind::kRequest
                                              ? reader_qos(kTopic.reader_depth)
                                              : latest_reader_qos(kTopic.reader_depth, late),
                                          listener);
  }

  // Of one robot's paths: who comes later gets its latest one.
  eprosima::fastdds::dds::DataReader* add_robot_path_reader(
      eprosima::fastdds::dds::DataReaderListener* listener) {
    auto* topic = add_topic_of<PathPiece>();
    if (topic == nullptr) return nullptr;
    return subscriber_->create_datareader(topic, latest_reader_qos(kRobotPathDepth, true),
                                          listener);
  }

 private:
  explicit FleetParticipant(std::uint64_t* refused) : refused_(refused) {}

  bool join(const std::string& partition);

  template <typename Value>
  eprosima::fastdds::dds::Topic* add_topic_of() {
    return add_topic(
        *participant_, fleet_topic_name(kFleetTopic<Value>),
        eprosima::fastdds::dds::TypeSupport(new typename Wire<Value>::Support(refused_)));
  }

  std::uint64_t* refused_;
  eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
  eprosima::fastdds::dds::Publisher* publisher_ = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber_ = nullptr;
};

// As Fast DDS writes it, its head included.
template <typename Value>
std::size_t serialized_bytes(const typename Wire<Value>::Type& sample) {
  constexpr std::size_t kHead = 4;
  return kHead + Wire<Value>::Type::getCdrSerializedSize(sample);
}

// False: not taken, since who requests are for has not taken those before, or DDS is in trouble.
// `traffic`: where it is counted; null: nowhere.
template <typename Value>
bool write(const Value& value, eprosima::fastdds::dds::DataWriter& writer,
           FleetTraffic* traffic = nullptr) {
  typename Wire<Value>::Type sample;
  to_wire(value, sample);
  if (!writer.write(&sample)) return false;  // bool: true is sent
  constexpr std::size_t kTopic = fleet_topic_index(kFleetTopic<Value>.name);
  if (traffic != nullptr) traffic->count_sent(kTopic, serialized_bytes<Value>(sample));
  return true;
}

// The next sample that can be read, if there is one.
template <typename Value>
std::optional<Value> read(eprosima::fastdds::dds::DataReader& reader,
                          FleetTraffic* traffic = nullptr) {
  typename Wire<Value>::Type sample;
  eprosima::fastdds::dds::SampleInfo info;
  while (reader.take_next_sample(&sample, &info) == ReturnCode_t::RETCODE_OK) {
    if (!info.valid_data) continue;
    constexpr std::size_t kTopic = fleet_topic_index(kFleetTopic<Value>.name);
    if (traffic != nullptr) traffic->count_received(kTopic, serialized_bytes<Value>(sample));
    return from_wire(sample);
  }
  return std::nullopt;
}

}  // namespace accord::dds
