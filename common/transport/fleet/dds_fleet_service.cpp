#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <utility>

#include "common/transport/dds/fleet/participant.h"
#include "common/transport/dds/fleet/plan_sender.h"
#include "common/transport/fleet/checked_service.h"
#include "common/transport/fleet/dds_fleet.h"

namespace accord {
namespace {

using namespace dds;
using eprosima::fastdds::dds::DataReader;
using eprosima::fastdds::dds::DataWriter;

class WakingListener final : public eprosima::fastdds::dds::DataReaderListener {
 public:
  explicit WakingListener(std::function<void()> wake) : wake_(std::move(wake)) {}
  void on_data_available(DataReader*) override { wake_(); }

 private:
  std::function<void()> wake_;
};

class DdsFleetService final : public CheckedService {
 public:
  explicit DdsFleetService(std::function<void()> wake) : listener_(std::move(wake)) {}

  std::optional<std::string> open(const DdsOptions& options) {
    auto participant = FleetParticipant::create(options, kServiceRole, nullptr, &refused_);
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
    plans_.emplace(*outlines, *paths);
    return std::nullopt;
  }

 private:
  std::optional<FleetRequest> do_take() override {
    // What is short and urgent first.
    if (auto cancel = read<CancelRequest>(*cancels_)) return cancel;
    if (auto resend = read<ResendRequest>(*resends_)) return resend;
    return read<PlanRequest>(*requests_);
  }
  bool do_publish(const FleetNews& news) override {
    return std::visit([this](const auto& kind) { return send(kind); }, news);
  }
  std::uint64_t unreadable() const override { return refused_; }

  bool send(const RequestReply& reply) { return write(reply, *replies_); }
  bool send(const RequestState& state) { return write(state, *states_); }
  bool send(const WorkerStatus& worker) { return write(worker, *workers_); }
  bool send(const ServiceStatus& service) { return write(service, *service_); }
  bool send(const FinishedPlan& plan) { return plans_->send(plan); }

  std::uint64_t refused_ = 0;
  WakingListener listener_;
  DataWriter* replies_ = nullptr;
  DataWriter* states_ = nullptr;
  DataWriter* workers_ = nullptr;
  DataWriter* service_ = nullptr;
  DataReader* cancels_ = nullptr;
  DataReader* resends_ = nullptr;
  DataReader* requests_ = nullptr;
  // Its threads have ended before what they call goes, and who writes before its writers.
  std::unique_ptr<FleetParticipant> participant_;
  std::optional<PlanSender> plans_;
};

}  // namespace

tl::expected<std::unique_ptr<FleetServicePort>, std::string> make_dds_fleet_service(
    const DdsOptions& options, std::function<void()> wake) {
  if (const auto fault = options_fault(options)) {
    return tl::unexpected(fault->option + ": " + fault->text);
  }
  auto service = std::make_unique<DdsFleetService>(std::move(wake));
  if (auto fault = service->open(options)) return tl::unexpected(std::move(*fault));
  return service;
}

}  // namespace accord
