// A discovery server: where participants that cannot find each other by multicast ask for who is
// there. It carries no messages of theirs; those that have met do without it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "common/transport/dds_options.h"

namespace accord {

inline constexpr std::uint16_t kDiscoveryPort = 11811;  // what Fast DDS's own server has
inline constexpr unsigned kMostDiscoveryServer = 255;

struct DiscoveryServerOptions {
  std::uint32_t domain = 0;  // at most kMostDomain
  unsigned id = 0;           // its place in DdsOptions::addresses of who asks it; at most 255
  std::vector<DdsAddress> listen{{"0.0.0.0", kDiscoveryPort}};  // 0.0.0.0: all of this machine's;
                                                                // port 0: kDiscoveryPort
  std::chrono::milliseconds lease{2000};                        // as in DdsOptions
  std::chrono::milliseconds announcement{200};
};

class DiscoveryServer {
 public:
  // Someone who came or went, as far as it is one of Accord's processes.
  struct Change {
    // "accord/CLUSTER/PROTOCOL/ROLE/ID", "accord-fleet/CLUSTER/VERSION/ROLE", else empty. From the
    // network: anything.
    std::string who;
    bool is_there = false;
    std::size_t present = 0;  // all that are there now, whosever
  };

  virtual ~DiscoveryServer() = default;
};

// Serves from now on, until it is destroyed, or says in a sentence why it cannot. `on_change` is
// called by DDS's threads, by one at a time, and must not block.
tl::expected<std::unique_ptr<DiscoveryServer>, std::string> make_dds_discovery_server(
    const DiscoveryServerOptions& options,
    std::function<void(const DiscoveryServer::Change&)> on_change);

}  // namespace accord
