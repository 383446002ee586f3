#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "client/doctor/probes/probes.h"

namespace accord {
namespace {

// A machine answers only so many datagrams to closed ports at once (net.ipv4.icmp_ratelimit).
constexpr std::uint32_t kPortsAnAddress = 3;
// From the domain's first port to a participant's, and from one participant's to the next one's.
constexpr std::uint32_t kFirstParticipant = 10, kNextParticipant = 2;
constexpr std::uint32_t kBase = 7400, kPortsADomain = 250;

// RTPS 2.3 with nothing in it, from nobody.
constexpr std::array<unsigned char, 20> kEmptyMessage{'R', 'T', 'P', 'S', 2, 3};

}  // namespace

AddressProbes::AddressProbes(const std::vector<DdsAddress>& addresses, const DdsOptions& options) {
  for (const DdsAddress& address : addresses) {
    probes_.push_back({address});
    const std::size_t place = probes_.size() - 1;
    if (address.port != 0) {
      send_to(place, address.port);
      continue;
    }
    for (std::uint32_t i = 0; i < kPortsAnAddress; ++i) {
      send_to(place, static_cast<std::uint16_t>(kBase + kPortsADomain * options.domain +
                                                kFirstParticipant + kNextParticipant * i));
    }
  }
}

AddressProbes::~AddressProbes() {
  for (const Sent& sent : sent_) close(sent.socket);
}

void AddressProbes::send_to(std::size_t place, std::uint16_t port) {
  AddressProbe& probe = probes_[place];
  ++probe.ports;
  const int out = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (out < 0) return;
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port);
  inet_pton(AF_INET, probe.address.ip.c_str(), &to.sin_addr);
  // Connected, so that what the other machine says of closed ports comes back to this socket.
  if (connect(out, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0 ||
      send(out, kEmptyMessage.data(), kEmptyMessage.size(), 0) < 0) {
    probe.fault = std::strerror(errno);
  }
  sent_.push_back({place, out});
}

std::vector<AddressProbe> AddressProbes::outcomes() {
  for (const Sent& sent : sent_) {
    int error = 0;
    socklen_t size = sizeof error;
    getsockopt(sent.socket, SOL_SOCKET, SO_ERROR, &error, &size);
    if (error == 0) continue;
    if (error == ECONNREFUSED) {
      ++probes_[sent.address].refused;
    } else {
      probes_[sent.address].fault = std::strerror(error);
    }
  }
  return probes_;
}

}  // namespace accord
