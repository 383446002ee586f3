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

// A service has 3 readers that ours writers match, and 6 writers.
constexpr std::size_t kPairs = 9;

class DdsFleetClient final : public AssemblingClient {
 public:
  explicit DdsFleetClient(const std::string& cluster)
      : watch_(fleet_user_data(cluster, kServiceRole), kPairs, signal_),
        listener_(watch_, signal_) {}

  std::optional<std::string> open(const DdsOptions& options) {
    auto participant =
        FleetParticipant::create(options, options.cluster, kClientRole, &listener_, &refused_);
    if (!participant) return participant.error();
    participant_ = std::move(*participant);
    requests_ = participant_->add_writer<PlanRequest>(&listener_);
    cancels_ = participant_->add_writer<CancelRequest>(&listener_);
    resends_ = participant_->add_writer<ResendRequest>(&listener_);
    replies_ = participant_->add_reader<RequestReply>(&listener_);
    states_ = participant_->add_reader<RequestState>(&listener_);
    outlines_ = participant_->add_reader<PlanOutline>(&listener_);
    paths_ = participant_->add_reader<PathPiece>(&listener_);
    workers_ = participant_->add_reader<WorkerStatus>(&listener_);
    service_ = participant_->add_reader<ServiceStatus>(&listener_);
    for (const DataWriter* writer : {requests_, cancels_, resends_}) {
      if (writer == nullptr) return "DDS refused a writer";
    }
    for (const DataReader* reader : {replies_, states_, outlines_, paths_, workers_, service_}) {
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
    return read<PathPiece>(*paths_);
  }
  void do_wait(std::chrono::nanoseconds timeout) override { signal_.wait(timeout); }
  std::uint64_t unreadable() const override { return refused_; }

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
    const DdsOptions& options) {
  if (const auto fault = options_fault(options)) {
    return tl::unexpected(fault->option + ": " + fault->text);
  }
  auto client = std::make_unique<DdsFleetClient>(options.cluster);
  if (auto fault = client->open(options)) return tl::unexpected(std::move(*fault));
  return client;
}

}  // namespace accord
