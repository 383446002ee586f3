#include "common/transport/dds_discovery.h"

#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "common/transport/dds/domain.h"
#include "common/transport/dds/qos.h"

namespace accord {
namespace {

using eprosima::fastdds::dds::DomainParticipant;
using eprosima::fastrtps::rtps::GuidPrefix_t;
using eprosima::fastrtps::rtps::ParticipantDiscoveryInfo;

// What the user data of coordinators and workers, and of fleet managers' ends, begins with.
constexpr std::array<std::string_view, 2> kOurs = {"accord/", "accord-fleet/"};

class Census final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  explicit Census(std::function<void(const DiscoveryServer::Change&)> on_change)
      : on_change_(std::move(on_change)) {}

  void on_participant_discovery(DomainParticipant*, ParticipantDiscoveryInfo&& info) override {
    const GuidPrefix_t& who = info.info.m_guid.guidPrefix;
    const bool is_there = info.status == ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT ||
                          info.status == ParticipantDiscoveryInfo::CHANGED_QOS_PARTICIPANT;
    const bool is_new = is_there ? present_.insert(who).second : present_.erase(who) > 0;
    if (!is_new) return;
    const auto& data = info.info.m_userData;
    std::string name(data.begin(), data.end());
    const bool is_ours = std::ranges::any_of(
        kOurs, [&name](std::string_view program) { return name.starts_with(program); });
    if (!is_ours) name.clear();
    on_change_({std::move(name), is_there, present_.size()});
  }

 private:
  std::function<void(const DiscoveryServer::Change&)> on_change_;
  std::set<GuidPrefix_t> present_;
};

class DdsDiscoveryServer final : public DiscoveryServer {
 public:
  explicit DdsDiscoveryServer(std::function<void(const Change&)> on_change)
      : census_(std::move(on_change)) {}
  ~DdsDiscoveryServer() override {
    if (participant_ != nullptr) dds::leave_domain(*participant_);
  }
  DdsDiscoveryServer(const DdsDiscoveryServer&) = delete;
  DdsDiscoveryServer& operator=(const DdsDiscoveryServer&) = delete;

  bool join(const DiscoveryServerOptions& options) {
    using namespace eprosima::fastdds::dds;
    participant_ = DomainParticipantFactory::get_instance()->create_participant(
        options.domain, dds::server_qos(options), &census_, StatusMask::none());
    return participant_ != nullptr;
  }

 private:
  Census census_;
  DomainParticipant* participant_ = nullptr;
};

}  // namespace

tl::expected<std::unique_ptr<DiscoveryServer>, std::string> make_dds_discovery_server(
    const DiscoveryServerOptions& options,
    std::function<void(const DiscoveryServer::Change&)> on_change) {
  auto server = std::make_unique<DdsDiscoveryServer>(std::move(on_change));
  if (server->join(options)) return server;
  return tl::unexpected(
      std::string("DDS could not serve; are the addresses this machine's, and the ports free?"));
}

}  // namespace accord
