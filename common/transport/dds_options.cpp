#include "common/transport/dds_options.h"

#include <algorithm>

#include "common/runtime/notation.h"

namespace accord {
namespace {

constexpr std::size_t kClusterBytes = 64;

bool may_name_a_cluster(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.';
}

}  // namespace

bool is_cluster_name(std::string_view text) {
  return !text.empty() && text.size() <= kClusterBytes &&
         std::ranges::all_of(text, may_name_a_cluster);
}

std::optional<OptionsFault> options_fault(const DdsOptions& options) {
  if (!is_cluster_name(options.cluster)) {
    return OptionsFault{"cluster", "expected 1 to 64 letters, digits, '-', '_' and '.'"};
  }
  if (options.domain > kMostDomain) {
    return OptionsFault{"domain", "expected 0 to 232, not " + std::to_string(options.domain)};
  }
  for (const std::string& interface : options.interfaces) {
    // Fast DDS takes anything, and then talks to nobody.
    if (!is_ipv4(interface)) {
      return OptionsFault{"interfaces", "expected IPv4 addresses, not \"" + interface + "\""};
    }
  }
  for (const DdsAddress& address : options.addresses) {
    if (!is_ipv4(address.ip)) {
      return OptionsFault{"addresses", "expected IPv4 addresses, not \"" + address.ip + "\""};
    }
    if (options.discovery == DdsOptions::Discovery::kServer && address.port == 0) {
      return OptionsFault{"addresses", "a discovery server has a port"};
    }
  }
  const bool by_address = options.discovery != DdsOptions::Discovery::kMulticast;
  if (by_address && options.addresses.empty()) {
    return OptionsFault{"addresses", "expected some, for discovery by peers or a server"};
  }
  if (by_address && options.transport == DdsOptions::Transport::kSharedMemory) {
    return OptionsFault{"transport", "shared memory alone needs no addresses; use udp or both"};
  }
  if (options.announcement.count() < 1 || options.lease < 2 * options.announcement) {
    return OptionsFault{"lease", "expected at least two announcements' time"};
  }
  if (options.segment_bytes < kLeastSegmentBytes || options.segment_bytes > kMostSegmentBytes) {
    return OptionsFault{"segment_bytes", "expected 1 MiB to 1 GiB"};
  }
  if (options.datagram_bytes < kLeastDatagramBytes || options.datagram_bytes > kMostDatagramBytes) {
    return OptionsFault{"datagram_bytes", "expected 1 KiB to 65500 bytes"};
  }
  return std::nullopt;
}

}  // namespace accord
