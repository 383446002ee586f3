#include "common/transport/dds_bus.h"

#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "common/transport/dds/conversions.h"
#include "common/transport/dds/participant.h"
#include "common/transport/message_limits.h"

namespace accord {
namespace {

using namespace dds;

// A coordinator's writers to a worker are kept for so many workers that are gone: one that was
// stopped, or cut off, comes back under its id.
constexpr std::size_t kGoneWorkers = 64;

// A worker has 4 writers that coordinators' readers match, and 3 readers.
constexpr std::size_t kPairs = kMessageKinds;

class DdsBus final : public Bus {
 public:
  explicit DdsBus(const PeerName& name)
      : Bus(name.id, name.role), name_(name), book_(name, kPairs, signal_) {}

  std::optional<std::string> open(const DdsOptions& options) {
    auto participant = Participant::create(options, name_, book_, signal_);
    if (!participant) return participant.error();
    participant_ = std::move(*participant);
    const bool coordinator = role() == Role::kCoordinator;
    const std::string coordinators = coordinators_partition(name_.cluster);
    const bool opened =
        coordinator ? participant_->add_readers(Role::kWorker, coordinators, readers_)
                    : participant_->add_readers(
                          Role::kCoordinator, worker_partition(name_.cluster, self()), readers_) &&
                          participant_->add_writers(Role::kWorker, coordinators, to_coordinators_);
    if (!opened) return "DDS refused a reader or a writer";
    return std::nullopt;
  }

 private:
  // ---- Out ----

  Published do_publish(EndpointId to, const Message& message) override {
    DataWriter* writer = writer_to(to, message.index());
    if (writer == nullptr) return Published::kNoPeer;
    return std::visit([&](const auto& kind) { return write(to, kind, *writer); }, message);
  }

  DataWriter* writer_to(EndpointId to, std::size_t kind) const {
    if (role() == Role::kWorker) return to_coordinators_.of_kind[kind];
    const auto found = to_workers_.find(to.value);
    return found == to_workers_.end() ? nullptr : found->second.of_kind[kind];
  }

  template <typename Kind>
  Published write(EndpointId to, const Kind& message, DataWriter& writer) {
    if (to == EndpointId{}) {
      eprosima::fastdds::dds::PublicationMatchedStatus status;
      writer.get_publication_matched_status(status);
      if (status.current_count == 0) return Published::kNoPeer;
    }
    typename Wire<Kind>::Type sample;
    sample.head().from(self().value);
    sample.head().to(to.value);
    to_wire(message, sample);
    return writer.write(&sample) ? Published::kSent : Published::kFull;  // bool: true is sent
  }

  // ---- In ----

  std::optional<BusEvent> do_take() override {
    auto event = next_event();
    drained_ = !event;
    return event;
  }

  std::optional<BusEvent> next_event() {
    while (const auto change = book_.next_change()) {
      switch (change->kind) {
        case PeerBook::Change::Kind::kDiscovered:
          meet(change->peer);
          break;
        case PeerBook::Change::Kind::kAppeared:
          return BusEvent{change->peer, PeerAppeared{}};
        case PeerBook::Change::Kind::kLost:
          return BusEvent{change->peer, PeerLost{}};
      }
    }
    return take_message(std::make_index_sequence<kMessageKinds>());
  }

  template <std::size_t... Places>
  std::optional<BusEvent> take_message(std::index_sequence<Places...>) {
    std::optional<BusEvent> event;
    static_cast<void>(((event = read<kUrgency[Places]>()) || ...));
    return event;
  }

  template <std::size_t Kind>
  std::optional<BusEvent> read() {
    DataReader* reader = readers_.of_kind[Kind];
    if (reader == nullptr) return std::nullopt;
    typename Wire<std::variant_alternative_t<Kind, Message>>::Type sample;
    eprosima::fastdds::dds::SampleInfo info;
    while (reader->take_next_sample(&sample, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      const EndpointId from{sample.head().from()};
      if (!is_for_us(EndpointId{sample.head().to()}, Kind) || !is_from(from, info)) {
        ++mutable_counters().foreign;
        continue;
      }
      return BusEvent{from, Message(from_wire(sample))};
    }
    return std::nullopt;
  }

  bool is_for_us(EndpointId to, std::size_t kind) const {
    return to == self() || (to == EndpointId{} && kind == kAnnouncements);
  }

  // Nobody can speak for another: an endpoint's name comes with its participant.
  bool is_from(EndpointId from, const eprosima::fastdds::dds::SampleInfo& info) const {
    const Guid writer = eprosima::fastrtps::rtps::iHandle2GUID(info.publication_handle);
    const auto known = book_.id_of(writer.guidPrefix);
    return from != EndpointId{} && (!known || *known == from);
  }

  bool do_wait(Duration timeout) override { return !drained_ || signal_.wait(timeout); }
  void do_wake() override { signal_.raise(); }

  // ---- Workers ----

  // A coordinator has writers of its own to each worker, so that one that does not listen holds
  // nobody else up.
  void meet(EndpointId peer) {
    if (role() != Role::kCoordinator || to_workers_.contains(peer.value)) return;
    if (to_workers_.size() >= peers().size() + kGoneWorkers) remove_gone();
    Writers& writers = to_workers_[peer.value];
    if (participant_->add_writers(Role::kCoordinator, worker_partition(name_.cluster, peer),
                                  writers)) {
      return;
    }
    participant_->remove(writers);
    to_workers_.erase(peer.value);
  }

  void remove_gone() {
    for (auto worker = to_workers_.begin(); worker != to_workers_.end();) {
      const bool gone = !book_.knows(EndpointId{worker->first});
      if (gone) participant_->remove(worker->second);
      worker = gone ? to_workers_.erase(worker) : std::next(worker);
    }
  }

  const PeerName name_;
  Signal signal_;
  PeerBook book_;
  Readers readers_;
  Writers to_coordinators_;
  std::unordered_map<std::uint64_t, Writers> to_workers_;
  bool drained_ = true;
  // Last, so that its threads have ended before what they call goes.
  std::unique_ptr<Participant> participant_;
};

}  // namespace

tl::expected<std::unique_ptr<Bus>, std::string> make_dds_bus(Role role, const DdsOptions& options) {
  if (const auto fault = options_fault(options)) {
    return tl::unexpected(fault->option + ": " + fault->text);
  }
  auto bus = std::make_unique<DdsBus>(
      PeerName{options.cluster, options.protocol, role, random_endpoint_id()});
  if (auto fault = bus->open(options)) return tl::unexpected(std::move(*fault));
  return bus;
}

}  // namespace accord
