#include <fastdds/rtps/attributes/ServerAttributes.h>

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <map>
#include <utility>

#include "common/transport/dds/conversions.h"
#include "common/transport/dds/domain.h"
#include "common/transport/dds/fleet/conversions.h"
#include "common/transport/dds/fleet/topics.h"
#include "common/transport/dds/qos.h"
#include "common/transport/dds/survey/survey_listener.h"
#include "common/transport/dds/topics.h"
#include "common/transport/fleet/fleet_limits.h"
#include "common/transport/survey/domain_survey.h"

namespace accord {
namespace {

using namespace dds;
using eprosima::fastdds::dds::DataReader;
using eprosima::fastdds::dds::DataReaderQos;
using eprosima::fastdds::dds::DomainParticipant;
using eprosima::fastdds::dds::Subscriber;
using eprosima::fastdds::dds::TypeSupport;

std::vector<SurveyBook::GuidPrefix> servers_of(const DdsOptions& options) {
  std::vector<SurveyBook::GuidPrefix> out;
  if (options.discovery != DdsOptions::Discovery::kServer) return out;
  for (std::size_t i = 0; i < options.addresses.size(); ++i) {
    eprosima::fastdds::rtps::get_server_client_default_guidPrefix(static_cast<int>(i),
                                                                  out.emplace_back());
  }
  return out;
}

// What is only listened to is not asked for again: workers never wait for who surveys them.
DataReaderQos eavesdropping_qos(std::size_t depth) {
  DataReaderQos qos = latest_reader_qos(depth, false);
  qos.reliability().kind = eprosima::fastdds::dds::BEST_EFFORT_RELIABILITY_QOS;
  return qos;
}

class DdsDomainWatch final : public DomainWatch {
 public:
  explicit DdsDomainWatch(const DdsOptions& options)
      : book_(servers_of(options), signal_), listener_(book_, signal_) {}
  ~DdsDomainWatch() override {
    if (participant_ != nullptr) leave_domain(*participant_);
  }

  std::optional<std::string> open(const DdsOptions& options, SurveyLook look) {
    const auto joined =
        join_domain(options, fleet_user_data(options.cluster, kDoctorRole), &listener_);
    if (!joined) return joined.error();
    participant_ = *joined;
    book_.set_own(participant_->guid().guidPrefix);
    if (look == SurveyLook::kPresence) return std::nullopt;
    Subscriber* news = subscriber(options.cluster);
    Subscriber* bus = subscriber(coordinators_partition(options.cluster));
    if (news == nullptr || bus == nullptr) return "DDS refused a partition";
    service_ = fleet_reader<ServiceStatus>(*news);
    workers_ = fleet_reader<WorkerStatus>(*news);
    heartbeats_ = bus_reader<Heartbeat>(*bus, options.protocol);
    if (service_ == nullptr || workers_ == nullptr || heartbeats_ == nullptr) {
      return "DDS refused a reader";
    }
    return std::nullopt;
  }

  void listen(std::chrono::nanoseconds timeout) override {
    signal_.wait(timeout);
    if (service_ == nullptr) return;
    while (auto status = read<ServiceStatus>(*service_, SurveyBook::Age::kKept)) {
      if (!fleet_fault(FleetNews(*status))) latest_ = std::move(*status);
    }
    while (auto status = read<WorkerStatus>(*workers_, SurveyBook::Age::kOld)) {
      const bool has_room = standing_.size() < kSeenParticipants;
      if (has_room && !fleet_fault(FleetNews(*status))) {
        const std::uint64_t worker = status->worker;
        standing_[worker] = std::move(*status);
      }
    }
    while (read<Heartbeat>(*heartbeats_, SurveyBook::Age::kLive)) {
    }
  }

  DomainSurvey survey() const override {
    DomainSurvey out{book_.participants(), latest_, {}};
    for (const auto& [worker, status] : standing_) out.workers.push_back(status);
    return out;
  }

 private:
  Subscriber* subscriber(const std::string& partition) {
    eprosima::fastdds::dds::SubscriberQos qos;
    qos.partition().push_back(partition.c_str());
    return participant_->create_subscriber(qos);
  }

  template <typename Value>
  DataReader* fleet_reader(Subscriber& subscriber) {
    constexpr const FleetTopic& kTopic = kFleetTopic<Value>;
    auto* topic = add_topic(*participant_, fleet_topic_name(kTopic),
                            TypeSupport(new typename Wire<Value>::Support()));
    if (topic == nullptr) return nullptr;
    return subscriber.create_datareader(topic, latest_reader_qos(kTopic.reader_depth, true),
                                        &listener_);
  }

  template <typename Kind>
  DataReader* bus_reader(Subscriber& subscriber, std::uint32_t protocol) {
    const std::size_t kKind = Message(Kind{}).index();
    auto* topic = add_topic(*participant_, topic_name(kKind, protocol),
                            TypeSupport(new typename Wire<Kind>::Support()));
    if (topic == nullptr) return nullptr;
    return subscriber.create_datareader(topic, eavesdropping_qos(kTopics[kKind].reader_depth),
                                        &listener_);
  }

  template <typename Value>
  std::optional<Value> read(DataReader& reader, SurveyBook::Age age) {
    typename Wire<Value>::Type sample;
    eprosima::fastdds::dds::SampleInfo info;
    while (reader.take_next_sample(&sample, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      book_.heard(info, age);
      return from_wire(sample);
    }
    return std::nullopt;
  }

  Signal signal_;
  SurveyBook book_;
  SurveyListener listener_;
  std::optional<ServiceStatus> latest_;
  std::map<std::uint64_t, WorkerStatus> standing_;
  DomainParticipant* participant_ = nullptr;
  DataReader* service_ = nullptr;
  DataReader* workers_ = nullptr;
  DataReader* heartbeats_ = nullptr;
};

}  // namespace

tl::expected<std::unique_ptr<DomainWatch>, std::string> make_dds_domain_watch(
    const DdsOptions& options, SurveyLook look) {
  if (const auto fault = options_fault(options)) {
    return tl::unexpected(fault->option + ": " + fault->text);
  }
  auto watch = std::make_unique<DdsDomainWatch>(options);
  if (auto fault = watch->open(options, look)) return tl::unexpected(std::move(*fault));
  return watch;
}

}  // namespace accord
