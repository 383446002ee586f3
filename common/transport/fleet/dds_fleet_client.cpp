#include <algorithm>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <utility>

#include "common/transport/dds/fleet/participant.h"
#include "common/transport/dds/fleet/service_watch.h"
#include "common/transport/fleet/dds_fleet.h"
#include "common/transport/fleet/fleet_limits.h"
#include "common/transport/fleet/plan_assembly.h"

namespace accord {
namespace {

using namespace dds;
using eprosima::fastdds::dds::DataReader;
using eprosima::fastdds::dds::DataWriter;

// A service has 3 readers that ours writers match, and 6 writers.
constexpr std::size_t kPairs = 9;

PlanAssembly::Time now() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

class DdsFleetClient final : public FleetClientPort {
 public:
  explicit DdsFleetClient(const std::string& cluster)
      : watch_(fleet_user_data(cluster, kServiceRole), kPairs, signal_),
        listener_(watch_, signal_) {}

  std::optional<std::string> open(const DdsOptions& options) {
    auto participant = FleetParticipant::create(options, kClientRole, &listener_, &refused_);
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

  bool send(const FleetRequest& request) override {
    if (fleet_fault(request) || !has_service()) return false;
    if (!std::visit([this](const auto& kind) { return send_kind(kind); }, request)) return false;
    ++counters_.sent;
    return true;
  }

  std::optional<FleetNews> take() override {
    auto news = next_news();
    if (news) ++counters_.received;
    drained_ = !news;
    counters_.malformed = refused_ + beyond_limits_ + assembly_.malformed();
    ask_again();
    return news;
  }

  void wait(std::chrono::nanoseconds timeout) override {
    if (!drained_) return;
    if (const auto due = assembly_.next_overdue()) timeout = std::min(timeout, *due - now());
    signal_.wait(std::max(timeout, std::chrono::nanoseconds(0)));
    ask_again();
  }

  bool has_service() const override { return watch_.is_there(); }
  const FleetCounters& counters() const override { return counters_; }

 private:
  bool send_kind(const PlanRequest& request) {
    assembly_.expect(request.id);
    return write(request, *requests_);
  }
  bool send_kind(const CancelRequest& request) { return write(request, *cancels_); }
  bool send_kind(const ResendRequest& request) {
    assembly_.expect(request.id);
    return write(request, *resends_);
  }

  std::optional<FleetNews> next_news() {
    if (auto reply = take_from<RequestReply>(*replies_)) return reply;
    if (auto state = take_from<RequestState>(*states_)) return state;
    if (auto service = take_from<ServiceStatus>(*service_)) return service;
    if (auto worker = take_from<WorkerStatus>(*workers_)) return worker;
    if (auto plan = plan_completed_by<PlanOutline>(*outlines_)) return plan;
    return plan_completed_by<PathPiece>(*paths_);
  }

  template <typename News>
  std::optional<FleetNews> take_from(DataReader& reader) {
    while (auto news = read<News>(reader)) {
      FleetNews out = std::move(*news);
      if (!fleet_fault(out)) return out;
      ++beyond_limits_;
    }
    return std::nullopt;
  }

  template <typename Part>
  std::optional<FleetNews> plan_completed_by(DataReader& reader) {
    while (auto part = read<Part>(reader)) {
      if (fleet_fault(*part)) {
        ++beyond_limits_;
      } else if (auto plan = assembly_.add(std::move(*part), now())) {
        return plan;
      }
    }
    return std::nullopt;
  }

  void ask_again() {
    for (std::string& id : assembly_.overdue(now())) {
      if (has_service()) write(ResendRequest{std::move(id)}, *resends_);
    }
  }

  Signal signal_;
  ServiceWatch watch_;
  ClientListener listener_;
  FleetCounters counters_;
  std::uint64_t refused_ = 0;        // samples that were none
  std::uint64_t beyond_limits_ = 0;  // that were
  PlanAssembly assembly_;
  bool drained_ = false;
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
