// Whether the kernel gives sockets the room that large messages need.
#include <fmt/format.h>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

// What common/transport asks for.
constexpr std::uint64_t kWanted = std::uint64_t{4} << 20;

}  // namespace

void check_socket_buffers(const Observations& seen, std::vector<Finding>& out) {
  if (!uses_udp(seen.options)) return;
  const SocketBuffers& buffers = seen.buffers;
  std::string text = fmt::format("sockets get at most {} to receive, {} to send",
                                 in_mebibytes(buffers.receive), in_mebibytes(buffers.send));
  if (buffers.receive >= kWanted && buffers.send >= kWanted) {
    out.push_back(fine(Concern::kSocketBuffers, std::move(text)));
    return;
  }
  Finding finding{Severity::kWarning,
                  Concern::kSocketBuffers,
                  text + fmt::format("; Accord asks for {}", in_mebibytes(kWanted)),
                  "What arrives while a process is busy is lost when the buffer is full, and is "
                  "sent again: scenes and plans of a megabyte take three to four times as long.",
                  {}};
  const auto mend = [&](const char* name, std::uint64_t value) {
    if (value < kWanted) finding.mend.push_back(fmt::format("sysctl -w {}={}", name, kWanted));
  };
  mend("net.core.rmem_max", buffers.receive);
  mend("net.core.wmem_max", buffers.send);
  finding.mend.front() += "    # on the host, where this is a container; keep it in /etc/sysctl.d";
  out.push_back(std::move(finding));
}

}  // namespace accord
