#include "common/transport/dds_settings.h"

#include <array>
#include <cstdint>
#include <utility>

#include "common/transport/dds_discovery.h"

namespace accord {
namespace {

using namespace std::chrono_literals;

constexpr std::array kTransports{
    std::pair<std::string_view, DdsOptions::Transport>{"shm", DdsOptions::Transport::kSharedMemory},
    std::pair<std::string_view, DdsOptions::Transport>{"udp", DdsOptions::Transport::kUdp},
    std::pair<std::string_view, DdsOptions::Transport>{"both", DdsOptions::Transport::kBoth}};

constexpr std::array kDiscoveries{
    std::pair<std::string_view, DdsOptions::Discovery>{"multicast",
                                                       DdsOptions::Discovery::kMulticast},
    std::pair<std::string_view, DdsOptions::Discovery>{"peers", DdsOptions::Discovery::kPeers},
    std::pair<std::string_view, DdsOptions::Discovery>{"server", DdsOptions::Discovery::kServer}};

std::optional<DdsAddress> address_in(std::string_view text) {
  const std::size_t colon = text.find(':');
  DdsAddress address{std::string(text.substr(0, colon))};
  if (!is_ipv4(address.ip)) return std::nullopt;
  if (colon == std::string_view::npos) return address;
  const auto port = whole_number<std::uint16_t>(1, UINT16_MAX).parse(text.substr(colon + 1));
  if (!port) return std::nullopt;
  address.port = *port;
  return address;
}

Notation<DdsAddress> address_with_port() {
  return {"an IPv4 address, with or without a port, as in 10.0.0.7:11811", "IP[:PORT]", address_in,
          [](const DdsAddress& address) {
            return address.ip + (address.port > 0 ? ":" + std::to_string(address.port) : "");
          },
          true};
}

void add_domain_setting(Settings& settings, std::uint32_t& domain) {
  settings.add("dds.domain", "--domain", domain, whole_number(0U, kMostDomain), "DDS domain");
}

void add_network_settings(Settings& settings, DdsOptions& options) {
  add_domain_setting(settings, options.domain);
  settings.add("dds.cluster", "--cluster", options.cluster,
               text("1 to 64 letters, digits, '-', '_' and '.'", "NAME", is_cluster_name),
               "Only processes of one cluster work together");
  settings.add("dds.transport", "--transport", options.transport,
               one_of<DdsOptions::Transport>(kTransports), "How messages travel");
  settings.add("dds.discovery", "--discovery", options.discovery,
               one_of<DdsOptions::Discovery>(kDiscoveries), "How processes find each other");
  settings.add_list("dds.addresses", "--address", options.addresses, address_with_port(),
                    "Where to ask for peers, or discovery servers in the order of their ids");
  settings
      .add_list("dds.interfaces", "--interface", options.interfaces, ipv4_address(),
                "Addresses of this machine to use")
      .initial = "all";
}

void add_lease_settings(Settings& settings, std::chrono::milliseconds& lease,
                        std::chrono::milliseconds& announcement) {
  settings.add("dds.lease", "--dds-lease", lease, rounded_seconds(2ms, 1h),
               "Silence until a process is given up");
  settings.add("dds.announcement", "--dds-announcement", announcement, rounded_seconds(1ms, 1h),
               "From one sign of life to the next");
}

void add_size_settings(Settings& settings, DdsOptions& options) {
  settings.add("dds.segment_bytes", "--dds-segment-bytes", options.segment_bytes,
               bytes(kLeastSegmentBytes, kMostSegmentBytes),
               "Shared memory for what this process sends");
  settings.add("dds.datagram_bytes", "--dds-datagram-bytes", options.datagram_bytes,
               bytes(kLeastDatagramBytes, kMostDatagramBytes),
               "What is sent at once; 1452 on links that lose frames");
}

}  // namespace

void add_dds_settings(Settings& settings, DdsOptions& options) {
  add_network_settings(settings, options);
  add_lease_settings(settings, options.lease, options.announcement);
  add_size_settings(settings, options);
  settings.add_check([&options]() -> std::optional<SettingFault> {
    auto fault = options_fault(options);
    if (!fault) return std::nullopt;
    return SettingFault{"dds." + fault->option, std::move(fault->text)};
  });
}

void add_discovery_server_settings(Settings& settings, DiscoveryServerOptions& options) {
  settings.add_list("listen", "--listen", options.listen, address_with_port(),
                    "Where it can be asked; 0.0.0.0 for all addresses of this machine");
  settings.add("id", "--id", options.id, whole_number(0U, kMostDiscoveryServer),
               "Its place in the dds.addresses of who asks it, from 0 on");
  add_domain_setting(settings, options.domain);
  add_lease_settings(settings, options.lease, options.announcement);
  settings.add_check([&options]() -> std::optional<SettingFault> {
    if (options.lease >= 2 * options.announcement) return std::nullopt;
    return SettingFault{"dds.lease", "expected at least two announcements' time"};
  });
}

}  // namespace accord
