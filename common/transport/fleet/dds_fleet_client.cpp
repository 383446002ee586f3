#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <utility>

#include "common/transport/dds/fleet/participant.h"
#include "common/transport/dds/fleet/service_watch.h"
#include "common/transport/fleet/assembling_client.h"
#include "common/transport/fleet/dds_fleet.h"

namespace accord {
namespace {

using namespace dds;
using eprosima::fastdds::dds::DataReader;
using eprosima::fastdds::dds::DataWriter;

// A service has 3 readers that our writers match, and 6 writers. Who hears no whole plans has
// neither use for requests nor for paths.
constexpr std::size_t pairs_for(HeardPlans plans) {
  return plans == HeardPlans::kWhole ? 9 : 7;
}

class DdsFleetClient final : public AssemblingClient {
 public:
  DdsFleetClient(const std::string& cluster, HeardPlans plans)
      : AssemblingClient(kPatience, plans),
        plans_(plans),
        watch_(fleet_user_data(cluster, kServiceRole), pairs_for(plans), signal_),
        listener_(watch_, signal_) {}

  std::optional<std::string> open(const DdsOptions& options) {
    auto participant =
        FleetParticipant::create(options, options.cluster, kClientRole, &listener_, &refused_);
    if (!participant) return participant.error();
    participant_ = std::move(*participant);
    if (has_paths()) {
      requests_ = participant_->add_writer<PlanRequest>(&listener_);
      paths_ = participant_->add_reader<PathPiece>(&listener_);
      if (requests_ == nullptr || paths_ == nullptr) return "DDS refused a reader or a writer";
    }
    cancels_ = participant_->add_writer<CancelRequest>(&listener_);
    resends_ = participant_->add_writer<ResendRequest>(&listener_);
    replies_ = participant_->add_reader<RequestReply>(&listener_);
    states_ = participant_->add_reader<RequestState>(&listener_);
    outlines_ = participant_->add_reader<PlanOutline>(
        &listener_, kFleetTopic<PlanOutline>.late || plans_ == HeardPlans::kAllOutcomes);
    workers_ = participant_->add_reader<WorkerStatus>(&listener_);
    service_ = participant_->add_reader<ServiceStatus>(&listener_);
    for (const DataWriter* writer : {cancels_, resends_}) {
      if (writer == nullptr) return "DDS refused a writer";
    }
    for (const DataReader* reader : {replies_, states_, outlines_, workers_, service_}) {
      if (reader == nullptr) return "DDS refused a reader";
    }
    return std::nullopt;
  }

  bool has_service() const override { return watch_.is_there(); }

 private:
  bool do_send(const FleetRequest& request) override {
    return std::visit([this](const auto& kind) { return send_kind(kind); }, request);
  }
  bool send_kind(const PlanRequest& request) { return write(request, *requests_); }
  bool send_kind(const CancelRequest& request) { return write(request, *cancels_); }
  bool send_kind(const ResendRequest& request) { return write(request, *resends_); }

  std::optional<FleetPart> do_take() override {
    if (auto reply = read<RequestReply>(*replies_)) return reply;
    if (auto state = read<RequestState>(*states_)) return state;
    if (auto service = read<ServiceStatus>(*service_)) return service;
    if (auto worker = read<WorkerStatus>(*workers_)) return worker;
    if (auto outline = read<PlanOutline>(*outlines_)) return outline;
    return has_paths() ? std::optional<FleetPart>(read<PathPiece>(*paths_)) : std::nullopt;
  }
  void do_wait(std::chrono::nanoseconds timeout) override { signal_.wait(timeout); }
  std::uint64_t unreadable() const override { return refused_; }

  bool has_paths() const { return plans_ == HeardPlans::kWhole; }

  const HeardPlans plans_;
  Signal signal_;
  ServiceWatch watch_;
  ClientListener listener_;
  std::uint64_t refused_ = 0;
  DataWriter* requests_ = nullptr;
  DataWriter* cancels_ = nullptr;
  DataWriter* resends_ = nullptr;
  DataReader* replies_ = nullptr;
  DataReader* states_ = nullptr;
  DataReader* outlines_ = nullptr;
  DataReader* paths_ = nullptr;
  DataReader* workers_ = nullptr;
  DataReader* service_ = nullptr;
  // Last, so that its threads have ended before what they call goes.
  std::unique_ptr<FleetParticipant> participant_;
};

}  // namespace

tl::expected<std::unique_ptr<FleetClientPort>, std::string> make_dds_fleet_client(
    const DdsOptions& options, HeardPlans plans) {
  if (const auto fault = options_fault(options)) {
    return tl::unexpected(fault->option + ": " + fault->text);
  }
  auto client = std::make_unique<DdsFleetClient>(options.cluster, plans);
  if (auto fault = client->open(options)) return tl::unexpected(std::move(*fault));
  return client;
}

}  // namespace accord
