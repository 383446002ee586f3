#include "common/transport/dds/qos.h"

#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "common/transport/dds/shared_memory.h"

namespace accord::dds {
namespace {

using namespace eprosima::fastdds::dds;
using eprosima::fastdds::rtps::SharedMemTransportDescriptor;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::Duration_t;
using eprosima::fastrtps::rtps::IPLocator;
using eprosima::fastrtps::rtps::Locator_t;

constexpr std::uint32_t kMebi = 1U << 20U;
constexpr std::uint32_t kSocketBuffer = 4 * kMebi;
constexpr std::uint32_t kLargestSharedMessage = 16 * kMebi;
// How many participants of one machine are looked for at each initial peer's address.
constexpr std::uint32_t kPeersAnAddress = 32;
constexpr const char* kLoopback = "127.0.0.1";
constexpr const char* kSharedMemory = "/dev/shm";

Duration_t duration(std::chrono::nanoseconds time) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  return {static_cast<std::int32_t>(time.count() / kSecond),
          static_cast<std::uint32_t>(time.count() % kSecond)};
}

// Where UDP listens. Fast DDS 2.9 has a discovery server answer participants of its own machine at
// 127.0.0.1, whatever address they gave, so those kept to other addresses listen there, too.
std::vector<std::string> interfaces_of(const DdsOptions& options) {
  std::vector<std::string> out = options.interfaces;
  const auto is_here = [&options](const DdsAddress& server) {
    return std::ranges::find(options.interfaces, server.ip) != options.interfaces.end();
  };
  if (options.discovery == DdsOptions::Discovery::kServer &&
      std::ranges::any_of(options.addresses, is_here) &&
      std::ranges::find(out, kLoopback) == out.end()) {
    out.emplace_back(kLoopback);
  }
  return out;
}

bool shares_memory(DdsOptions::Transport transport) {
  if (transport != DdsOptions::Transport::kBoth) {
    return transport == DdsOptions::Transport::kSharedMemory;
  }
  return !others_share_memory(kSharedMemory, geteuid());
}

void add_transports(const DdsOptions& options, DomainParticipantQos& qos) {
  qos.transport().use_builtin_transports = false;
  if (shares_memory(options.transport)) {
    auto memory = std::make_shared<SharedMemTransportDescriptor>();
    const auto segment = static_cast<std::uint32_t>(options.segment_bytes);
    memory->segment_size(segment);
    memory->max_message_size(std::min(kLargestSharedMessage, segment / 4));
    qos.transport().user_transports.push_back(std::move(memory));
  }
  if (options.transport != DdsOptions::Transport::kSharedMemory) {
    auto udp = std::make_shared<UDPv4TransportDescriptor>();
    udp->interfaceWhiteList = interfaces_of(options);
    udp->maxMessageSize = static_cast<std::uint32_t>(options.datagram_bytes);
    udp->sendBufferSize = kSocketBuffer;
    udp->receiveBufferSize = kSocketBuffer;
    udp->maxInitialPeersRange = kPeersAnAddress;
    qos.transport().user_transports.push_back(std::move(udp));
  }
}

Locator_t locator(const DdsAddress& address) {
  Locator_t out;
  out.kind = LOCATOR_KIND_UDPv4;
  IPLocator::setIPv4(out, address.ip);
  out.port = address.port;
  return out;
}

void add_addresses(const DdsOptions& options, DomainParticipantQos& qos) {
  auto& builtin = qos.wire_protocol().builtin;
  if (options.discovery != DdsOptions::Discovery::kMulticast) {
    // An empty locator stands for the usual unicast ports; without multicast ones none are opened.
    builtin.metatrafficUnicastLocatorList.push_back(Locator_t());
  }
  if (options.discovery == DdsOptions::Discovery::kPeers) {
    for (const DdsAddress& address : options.addresses) {
      builtin.initialPeersList.push_back(locator(address));
    }
  } else if (options.discovery == DdsOptions::Discovery::kServer) {
    builtin.discovery_config.discoveryProtocol =
        eprosima::fastrtps::rtps::DiscoveryProtocol_t::CLIENT;
    builtin.discovery_config.discoveryServer_client_syncperiod = duration(options.announcement);
    for (std::size_t i = 0; i < options.addresses.size(); ++i) {
      eprosima::fastdds::rtps::RemoteServerAttributes server;
      eprosima::fastdds::rtps::get_server_client_default_guidPrefix(static_cast<int>(i),
                                                                    server.guidPrefix);
      server.metatrafficUnicastLocatorList.push_back(locator(options.addresses[i]));
      builtin.discovery_config.m_DiscoveryServers.push_back(server);
    }
  }
}

// Limits of a history whose samples differ in size from bytes to megabytes.
template <typename Qos>
void bound(std::size_t depth, Qos& qos) {
  qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
  qos.history().kind = KEEP_ALL_HISTORY_QOS;
  qos.resource_limits().max_samples = static_cast<std::int32_t>(depth);
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = static_cast<std::int32_t>(depth);
  qos.resource_limits().allocated_samples = 1;
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::DYNAMIC_RESERVE_MEMORY_MODE;
  qos.data_sharing().off();
}

template <typename Qos>
void keep_last(std::size_t depth, Qos& qos) {
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = static_cast<std::int32_t>(depth);
}

}  // namespace

DomainParticipantQos participant_qos(const DdsOptions& options, const std::string& user_data) {
  DomainParticipantQos qos;
  qos.name("accord");
  qos.user_data().assign(user_data.begin(), user_data.end());
  auto& discovery = qos.wire_protocol().builtin.discovery_config;
  discovery.leaseDuration = duration(options.lease);
  discovery.leaseDuration_announcementperiod = duration(options.announcement);
  // What is written goes to each reader's own address. Else Fast DDS sends it to all hosts of the
  // domain where two readers listen for multicast, as those of Cyclone DDS do. Discovery does not
  // look at this.
  qos.allocation().locators.max_multicast_locators = 0;
  add_transports(options, qos);
  add_addresses(options, qos);
  return qos;
}

DomainParticipantQos server_qos(const DiscoveryServerOptions& options) {
  DomainParticipantQos qos;
  qos.name("accord-discovery");
  auto& builtin = qos.wire_protocol().builtin;
  builtin.discovery_config.discoveryProtocol =
      eprosima::fastrtps::rtps::DiscoveryProtocol_t::SERVER;
  builtin.discovery_config.leaseDuration = duration(options.lease);
  builtin.discovery_config.leaseDuration_announcementperiod = duration(options.announcement);
  eprosima::fastdds::rtps::get_server_client_default_guidPrefix(static_cast<int>(options.id),
                                                                qos.wire_protocol().prefix);
  for (DdsAddress address : options.listen) {
    if (address.port == 0) address.port = kDiscoveryPort;
    builtin.metatrafficUnicastLocatorList.push_back(locator(address));
  }
  // UDP alone: shared memory would have to be shared by whoever asks.
  qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->sendBufferSize = kSocketBuffer;
  udp->receiveBufferSize = kSocketBuffer;
  qos.transport().user_transports.push_back(std::move(udp));
  return qos;
}

DataWriterQos writer_qos(std::size_t depth) {
  using namespace std::chrono_literals;
  DataWriterQos qos;
  bound(depth, qos);
  // Readers are volatile, so nobody gets old samples. But a volatile writer deletes them as they
  // are acknowledged, and when that is because a reader leaves, it may deadlock with the thread
  // that sends again (Fast DDS 2.9.1: the locators' lock and the flow controller's, taken in either
  // order). This one deletes them when it needs room.
  qos.durability().kind = TRANSIENT_LOCAL_DURABILITY_QOS;
  // How long a write waits where the history is full. It must not be 0: the wait covers locks, too.
  qos.reliability().max_blocking_time = duration(5ms);
  auto& times = qos.reliable_writer_qos().times;
  times.initialHeartbeatDelay = duration(0ms);
  times.heartbeatPeriod = duration(20ms);
  times.nackResponseDelay = duration(0ms);
  times.nackSupressionDuration = duration(0ms);
  return qos;
}

DataReaderQos reader_qos(std::size_t depth) {
  using namespace std::chrono_literals;
  DataReaderQos qos;
  bound(depth, qos);
  qos.durability().kind = VOLATILE_DURABILITY_QOS;
  // Said again after twice as long each time, until the writer is heard: from 0 on that is a storm,
  // which chokes slow links and never lets the writer be heard.
  qos.reliable_reader_qos().times.initialAcknackDelay = duration(20ms);
  qos.reliable_reader_qos().times.heartbeatResponseDelay = duration(0ms);
  return qos;
}

DataWriterQos latest_writer_qos(std::size_t depth) {
  DataWriterQos qos = writer_qos(depth);
  keep_last(depth, qos);
  return qos;
}

DataReaderQos latest_reader_qos(std::size_t depth, bool late) {
  DataReaderQos qos = reader_qos(depth);
  keep_last(depth, qos);
  if (late) qos.durability().kind = TRANSIENT_LOCAL_DURABILITY_QOS;
  return qos;
}

}  // namespace accord::dds
