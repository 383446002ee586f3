// What `accord doctor` has seen of this machine and of the domain: plain values, which probes/
// gathers and diagnosis.h judges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/transport/dds_options.h"
#include "common/transport/survey/domain_survey.h"

namespace accord {

inline constexpr const char* kSharedMemoryFolder = "/dev/shm";

// What Fast DDS has in /dev/shm: a segment for what each participant sends, fastrtps_<16 digits>,
// and a port for each that it listens on, fastrtps_port<N>. Their owners hold a lock on a file
// beside each, _el, for as long as they live.
struct SharedMemory {
  bool is_usable = false;  // the folder is there, and files can be made in it
  std::uint64_t bytes = 0;
  std::uint64_t free_bytes = 0;
  std::size_t owned = 0;  // segments whose owner lives, or may live: not ours to open
  // Files of those whose lock nobody holds, in order of their names.
  std::vector<std::string> stale;
  std::uint64_t stale_bytes = 0;
  bool has_foreign_stale = false;  // of another user: only that one or root may remove them
  // Another user of whom there is something of Fast DDS's, alive or not: a process that may use
  // both leaves shared memory then (common/transport/dds/shared_memory.h).
  std::optional<std::uint32_t> other_user = std::nullopt;
};

// A port in shared memory that a participant of this machine says to listen on.
struct SharedPort {
  enum class State {
    kMissing,  // not in this /dev/shm
    kOwn,      // there, but it is this process that listens on it
    kDenied,   // there, but not for this user to open
    kOpen,
  };
  State state = State::kMissing;
  std::uint32_t owner = 0;  // user id, unless missing
};

struct SocketBuffers {
  std::uint64_t receive = 0;  // bytes: the most that the kernel gives
  std::uint64_t send = 0;
};

// An IPv4 address of this machine.
struct Interface {
  std::string name;
  std::string ip;
  bool is_up = false;
  bool is_loopback = false;
  bool has_multicast_flag = false;
  // Why a datagram to the domain's multicast group did not come back through it; nullopt: it did,
  // or was not tried.
  std::optional<std::string> multicast_fault;
};

// What came of datagrams to an address.
struct AddressProbe {
  DdsAddress address = {};
  std::size_t ports = 0;    // that were tried
  std::size_t refused = 0;  // of them, those where nobody listens, as that machine said
  std::string fault = {};   // as the system says: no route, no such host; empty: silence
};

// What one participant of ours saw of the domain.
struct Look {
  std::string join_fault;  // empty: it has joined
  DomainSurvey survey;
};

struct Observations {
  DdsOptions options;   // what was told
  std::string version;  // of this program
  std::uint32_t user = 0;
  double listened = 0;  // s

  SharedMemory memory;
  SocketBuffers buffers;
  std::vector<Interface> interfaces;
  std::set<std::uint32_t> domains_here;  // where processes of this machine listen for multicast
  std::vector<AddressProbe> addresses;   // those of the options, in their order

  Look as_told;
  // Who is there beyond that: over UDP by multicast on all interfaces, and by shared memory alone,
  // whose users see nobody but each other.
  std::optional<Look> by_udp;
  std::optional<Look> by_memory;

  // Of participants that have told nothing of their readers and writers, by guid.
  std::map<std::uint32_t, SharedPort> shared_ports;
  std::map<std::string, std::vector<AddressProbe>> silent;
};

}  // namespace accord
