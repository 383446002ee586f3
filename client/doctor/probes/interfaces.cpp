#include <arpa/inet.h>
#include <fmt/format.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>

#include "client/doctor/probes/probes.h"

namespace accord {
namespace {

constexpr const char* kGroup = "239.255.0.1";  // of DDS's discovery
constexpr int kTries = 3;
constexpr int kWait = 100;  // ms, for each

class UdpSocket {
 public:
  UdpSocket() : file_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~UdpSocket() {
    if (file_ >= 0) close(file_);
  }
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;
  int file() const { return file_; }

 private:
  int file_;
};

std::string reason() {
  return std::strerror(errno);
}

sockaddr_in address(in_addr ip, std::uint16_t port) {
  sockaddr_in out{};
  out.sin_family = AF_INET;
  out.sin_addr = ip;
  out.sin_port = port;
  return out;
}

in_addr parsed(const std::string& ip) {
  in_addr out{};
  inet_pton(AF_INET, ip.c_str(), &out);
  return out;
}

const sockaddr* generic(const sockaddr_in& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

// Listens for the group on one interface, at a port that the system chooses; 0: it could not.
std::uint16_t join(const UdpSocket& socket, in_addr interface) {
  sockaddr_in any = address(in_addr{htonl(INADDR_ANY)}, 0);
  if (bind(socket.file(), generic(any), sizeof any) != 0) return 0;
  const ip_mreq group{parsed(kGroup), interface};
  if (setsockopt(socket.file(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) != 0) return 0;
  socklen_t size = sizeof any;
  if (getsockname(socket.file(), reinterpret_cast<sockaddr*>(&any), &size) != 0) return 0;
  return any.sin_port;
}

bool has_come(const UdpSocket& socket, const std::array<std::uint32_t, 4>& token) {
  pollfd wait{socket.file(), POLLIN, 0};
  while (poll(&wait, 1, kWait) > 0) {
    std::array<std::uint32_t, 4> came{};
    if (recv(socket.file(), came.data(), sizeof came, 0) < 0) return false;
    if (came == token) return true;
  }
  return false;
}

std::optional<std::string> multicast_fault(const std::string& ip) {
  const in_addr interface = parsed(ip);
  const UdpSocket receiver, sender;
  const std::uint16_t port = join(receiver, interface);
  if (port == 0) return fmt::format("cannot join {}: {}", kGroup, reason());
  if (setsockopt(sender.file(), IPPROTO_IP, IP_MULTICAST_IF, &interface, sizeof interface) != 0) {
    return fmt::format("cannot send to {}: {}", kGroup, reason());
  }
  std::random_device random;
  const std::array<std::uint32_t, 4> token{random(), random(), random(), random()};
  const sockaddr_in group = address(parsed(kGroup), port);
  for (int i = 0; i < kTries; ++i) {
    if (sendto(sender.file(), token.data(), sizeof token, 0, generic(group), sizeof group) < 0) {
      return fmt::format("cannot send to {}: {}", kGroup, reason());
    }
    if (has_come(receiver, token)) return std::nullopt;
  }
  return fmt::format("{} datagrams to {} did not come back", kTries, kGroup);
}

// One number of a file; 0: it is not there.
std::uint64_t number_in(const char* path) {
  std::uint64_t out = 0;
  std::ifstream(path) >> out;
  return out;
}

// What a socket really gets; the kernel counts its own bookkeeping as much again.
std::uint64_t granted(int option) {
  const UdpSocket socket;
  int wanted = 64 << 20;
  setsockopt(socket.file(), SOL_SOCKET, option, &wanted, sizeof wanted);
  socklen_t size = sizeof wanted;
  if (getsockopt(socket.file(), SOL_SOCKET, option, &wanted, &size) != 0) return 0;
  return static_cast<std::uint64_t>(wanted) / 2;
}

}  // namespace

std::vector<Interface> look_at_interfaces() {
  std::vector<Interface> out;
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return out;
  for (const ifaddrs* at = first; at != nullptr; at = at->ifa_next) {
    if (at->ifa_addr == nullptr || at->ifa_addr->sa_family != AF_INET) continue;
    std::array<char, INET_ADDRSTRLEN> ip{};
    const auto* ours = reinterpret_cast<const sockaddr_in*>(at->ifa_addr);
    inet_ntop(AF_INET, &ours->sin_addr, ip.data(), ip.size());
    const auto is = [at](unsigned flag) { return (at->ifa_flags & flag) != 0; };
    Interface interface {
      at->ifa_name, ip.data(), is(IFF_UP) && is(IFF_RUNNING), is(IFF_LOOPBACK),
          is(IFF_MULTICAST), std::nullopt
    };
    if (interface.is_up) interface.multicast_fault = multicast_fault(interface.ip);
    out.push_back(std::move(interface));
  }
  freeifaddrs(first);
  return out;
}

SocketBuffers look_at_socket_buffers() {
  // In a container the files may be missing; what is granted is as much as they say.
  SocketBuffers out{number_in("/proc/sys/net/core/rmem_max"),
                    number_in("/proc/sys/net/core/wmem_max")};
  if (out.receive == 0) out.receive = granted(SO_RCVBUF);
  if (out.send == 0) out.send = granted(SO_SNDBUF);
  return out;
}

std::set<std::uint32_t> look_at_domains() {
  constexpr std::uint32_t kBase = 7400, kPorts = 250;
  std::set<std::uint32_t> out;
  std::ifstream table("/proc/net/udp");
  for (std::string line; std::getline(table, line);) {
    std::istringstream words(line);
    std::string slot, local;
    words >> slot >> local;
    const std::size_t colon = local.find(':');
    if (colon == std::string::npos) continue;
    const unsigned long port = std::strtoul(local.c_str() + colon + 1, nullptr, 16);
    if (port < kBase || (port - kBase) % kPorts != 0) continue;
    const auto domain = static_cast<std::uint32_t>((port - kBase) / kPorts);
    if (domain <= kMostDomain) out.insert(domain);
  }
  return out;
}

}  // namespace accord
