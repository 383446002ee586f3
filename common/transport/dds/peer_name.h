// How endpoints tell each other who they are: in the user data of their participants, which comes
// with discovery, before any message.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/transport/endpoint_id.h"

namespace accord::dds {

struct PeerName {
  std::string cluster;
  std::uint32_t protocol = 0;
  Role role = Role::kWorker;
  EndpointId id;
};

// "accord/CLUSTER/PROTOCOL/coordinator/ID".
std::string to_user_data(const PeerName& name);

// nullopt for whoever is no endpoint of ours. Takes any bytes.
std::optional<PeerName> parse_user_data(std::string_view text);

}  // namespace accord::dds
