// How an endpoint finds and reaches its peers over DDS.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/transport/messages.h"

namespace accord {

inline constexpr std::uint32_t kMostDomain = 232;  // beyond it ports end
inline constexpr std::size_t kLeastSegmentBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMostSegmentBytes = std::size_t{1} << 30;
inline constexpr std::size_t kLeastDatagramBytes = std::size_t{1} << 10;
inline constexpr std::size_t kMostDatagramBytes = 65'500;

struct DdsAddress {
  std::string ip;          // IPv4
  std::uint16_t port = 0;  // 0: the domain's own

  friend bool operator==(const DdsAddress&, const DdsAddress&) = default;
};

struct DdsOptions {
  enum class Transport {
    kSharedMemory,  // this machine only, and only processes that see the same /dev/shm
    kUdp,
    kBoth,  // shared memory where it reaches; UDP alone where another user's is on the machine. Not
            // for containers that share the host's network but not its /dev/shm: they would find
            // each other and never talk
  };
  enum class Discovery {
    kMulticast,
    kPeers,   // `addresses` are asked, each at the ports of the domain's first participants
    kServer,  // `addresses` are Fast DDS discovery servers, with the ids 0, 1, ... in that order
  };

  // Endpoints of one cluster talk to each other only, whatever else is in the domain.
  // See is_cluster_name().
  std::string cluster = "default";
  std::uint32_t domain = 0;  // at most kMostDomain
  Transport transport = Transport::kBoth;
  Discovery discovery = Discovery::kMulticast;
  std::vector<std::string> interfaces;  // IPv4 addresses of this machine to use; empty: all
  std::vector<DdsAddress> addresses;
  std::chrono::milliseconds lease{2000};              // of silence, until a process is given up
  std::chrono::milliseconds announcement{200};        // from one sign of life to the next
  std::size_t segment_bytes = std::size_t{64} << 20;  // of shared memory, for what this one sends;
                                                      // containers have 64 MB of it unless told
  // Of what goes out at once; longer messages go in parts. A datagram is lost with any of its
  // frames, so on links that lose many it should fit in one: 1452. Shared memory, where it is in
  // use beside UDP, has the same parts.
  std::size_t datagram_bytes = kMostDatagramBytes;
  std::uint32_t protocol = kProtocol;  // another one: for tests of strangers
};

// Letters, digits, '-', '_', '.'; 1 to 64 of them.
bool is_cluster_name(std::string_view text);

struct OptionsFault {
  std::string option;  // the name of a member of DdsOptions
  std::string text;    // what is wrong with it, and what was expected
};

// Why options make no sense; nullopt where they do.
std::optional<OptionsFault> options_fault(const DdsOptions& options);

}  // namespace accord
