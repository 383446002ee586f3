#include "common/transport/dds_options.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace accord {
namespace {

constexpr std::uint32_t kMostDomain = 232;  // beyond it ports end
constexpr std::size_t kClusterBytes = 64;

bool may_name_a_cluster(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.';
}

// Fast DDS takes anything, and then talks to nobody.
bool is_ipv4(std::string_view text) {
  for (int part = 0; part < 4; ++part) {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || value > 255) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (part == 3) return text.empty();
    if (!text.starts_with('.')) return false;
    text.remove_prefix(1);
  }
  return false;
}

}  // namespace

std::optional<std::string> options_fault(const DdsOptions& options) {
  if (options.cluster.empty() || options.cluster.size() > kClusterBytes ||
      !std::ranges::all_of(options.cluster, may_name_a_cluster)) {
    return "cluster: expected 1 to 64 letters, digits, '-', '_' and '.'";
  }
  if (options.domain > kMostDomain) {
    return "domain: expected 0 to 232, not " + std::to_string(options.domain);
  }
  for (const std::string& interface : options.interfaces) {
    if (!is_ipv4(interface))
      return "interfaces: expected IPv4 addresses, not \"" + interface + "\"";
  }
  for (const DdsAddress& address : options.addresses) {
    if (!is_ipv4(address.ip)) {
      return "addresses: expected IPv4 addresses, not \"" + address.ip + "\"";
    }
    if (options.discovery == DdsOptions::Discovery::kServer && address.port == 0) {
      return "addresses: a discovery server has a port";
    }
  }
  const bool by_address = options.discovery != DdsOptions::Discovery::kMulticast;
  if (by_address && options.addresses.empty()) {
    return "addresses: expected some, for discovery by peers or a server";
  }
  if (by_address && options.transport == DdsOptions::Transport::kSharedMemory) {
    return "transport: shared memory alone needs no addresses; use udp or both";
  }
  if (options.announcement.count() < 1 || options.lease < 2 * options.announcement) {
    return "lease: expected at least two announcements' time";
  }
  if (options.segment_bytes < (std::size_t{1} << 20) ||
      options.segment_bytes > (std::size_t{1} << 30)) {
    return "segment_bytes: expected 1 MiB to 1 GiB";
  }
  return std::nullopt;
}

}  // namespace accord
