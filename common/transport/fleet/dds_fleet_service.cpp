#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <string_view>
#include <utility>

#include "common/transport/dds/fleet/participant.h"
#include "common/transport/dds/fleet/plan_sender.h"
#include "common/transport/dds/fleet/waking_listener.h"
#include "common/transport/fleet/checked_service.h"
#include "common/transport/fleet/dds_fleet.h"

namespace accord {
namespace {

using namespace dds;
using eprosima::fastdds::dds::DataReader;
using eprosima::fastdds::dds::DataWriter;

// Hears of readers that come and go. Does nothing else: to create or delete anything in a callback
// is a deadlock.
class RobotListener final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  explicit RobotListener(RobotReaders& robots) : robots_(robots) {}

  void on_subscriber_discovery(eprosima::fastdds::dds::DomainParticipant*,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override {
    using eprosima::fastrtps::rtps::ReaderDiscoveryInfo;
    const auto& reader = info.info;
    if (std::string_view(reader.topicName().c_str()) != topic_) return;
    const bool is_there = info.status == ReaderDiscoveryInfo::DISCOVERED_READER ||
                          info.status == ReaderDiscoveryInfo::CHANGED_QOS_READER;
    if (is_there) {
      robots_.found(reader.guid(), reader.m_qos.m_partition.getNames());
    } else {
      robots_.gone(reader.guid());
    }
  }
  void on_participant_discovery(
      eprosima::fastdds::dds::DomainParticipant*,
      eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override {
    using eprosima::fastrtps::rtps::ParticipantDiscoveryInfo;
    const bool is_gone = info.status == ParticipantDiscoveryInfo::REMOVED_PARTICIPANT ||
                         info.status == ParticipantDiscoveryInfo::DROPPED_PARTICIPANT;
    if (is_gone) robots_.gone(info.info.m_guid.guidPrefix);
  }

 private:
  const std::string topic_ = fleet_topic_name(kFleetTopic<PathPiece>);
  RobotReaders& robots_;
};

class DdsFleetService final : public CheckedService {
 public:
  DdsFleetService(const std::string& cluster, std::function<void()> wake)
      : listener_(std::move(wake)), robots_(cluster), robot_listener_(robots_) {}

  std::optional<std::string> open(const DdsOptions& options, const RosOptions& ros) {
    auto participant = FleetParticipant::create(options, options.cluster, kServiceRole,
                                                &robot_listener_, &refused_);
    if (!participant) return participant.error();
    participant_ = std::move(*participant);
    replies_ = participant_->add_writer<RequestReply>(nullptr);
    states_ = participant_->add_writer<RequestState>(nullptr);
    workers_ = participant_->add_writer<WorkerStatus>(nullptr);
    service_ = participant_->add_writer<ServiceStatus>(nullptr);
    DataWriter* outlines = participant_->add_writer<PlanOutline>(nullptr);
    DataWriter* paths = participant_->add_writer<PathPiece>(nullptr);
    // Readers last: a client that finds them finds all.
    cancels_ = participant_->add_reader<CancelRequest>(&listener_);
    resends_ = participant_->add_reader<ResendRequest>(&listener_);
    requests_ = participant_->add_reader<PlanRequest>(&listener_);
    for (const DataWriter* writer : {replies_, states_, workers_, service_, outlines, paths}) {
      if (writer == nullptr) return "DDS refused a writer";
    }
    for (const DataReader* reader : {cancels_, resends_, requests_}) {
      if (reader == nullptr) return "DDS refused a reader";
    }
    plans_.emplace(options.cluster, ros, *outlines, *paths, robots_, traffic_);
    return std::nullopt;
  }

 private:
  std::optional<FleetRequest> do_take() override {
    // What is short and urgent first.
    if (auto cancel = read<CancelRequest>(*cancels_, &traffic_)) return cancel;
    if (auto resend = read<ResendRequest>(*resends_, &traffic_)) return resend;
    return read<PlanRequest>(*requests_, &traffic_);
  }
  bool do_publish(const FleetNews& news) override {
    return std::visit([this](const auto& kind) { return send(kind); }, news);
  }
  std::uint64_t unreadable() const override { return refused_; }
  FleetTraffic::Totals traffic() const override { return traffic_.totals(); }

  bool send(const RequestReply& reply) { return write(reply, *replies_, &traffic_); }
  bool send(const RequestState& state) { return write(state, *states_, &traffic_); }
  bool send(const WorkerStatus& worker) { return write(worker, *workers_, &traffic_); }
  bool send(const ServiceStatus& service) { return write(service, *service_, &traffic_); }
  bool send(const FinishedPlan& plan) { return plans_->send(plan); }

  std::uint64_t refused_ = 0;
  FleetTraffic traffic_;
  WakingListener listener_;
  DataWriter* replies_ = nullptr;
  DataWriter* states_ = nullptr;
  DataWriter* workers_ = nullptr;
  DataWriter* service_ = nullptr;
  DataReader* cancels_ = nullptr;
  DataReader* resends_ = nullptr;
  DataReader* requests_ = nullptr;
  RobotReaders robots_;
  RobotListener robot_listener_;
  // Its threads have ended before what they call goes, and who writes before its writers.
  std::unique_ptr<FleetParticipant> participant_;
  std::optional<PlanSender> plans_;
};

}  // namespace

tl::expected<std::unique_ptr<FleetServicePort>, std::string> make_dds_fleet_service(
    const DdsOptions& options, std::function<void()> wake, const RosOptions& ros) {
  if (const auto fault = options_fault(options)) {
    return tl::unexpected(fault->option + ": " + fault->text);
  }
  auto service = std::make_unique<DdsFleetService>(options.cluster, std::move(wake));
  if (auto fault = service->open(options, ros)) return tl::unexpected(std::move(*fault));
  return service;
}

}  // namespace accord
