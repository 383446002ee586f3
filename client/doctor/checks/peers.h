// Participants of the cluster, and why nothing comes from one: what several checks ask.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "client/doctor/observations.h"

namespace accord {

using Peers = std::vector<const SeenParticipant*>;

bool uses_shared_memory(const DdsOptions& options);
// Whether a process that starts now leaves it, since another user's is there.
bool leaves_shared_memory(const Observations& seen);
// Whether it is told to use nothing else, and finds nobody where only another user's is.
bool is_shut_out_of_memory(const Observations& seen);
bool uses_udp(const DdsOptions& options);

// Of our cluster, of whatever protocol; clients not.
Peers members(const Observations& seen, const DomainSurvey& survey);
bool speaks_our_protocol(const Observations& seen, const AccordName& name);

// Whether anything came from it to this process's own address.
bool is_reached(const SeenParticipant& peer);

enum class Silence {
  kNone,          // it is reached
  kSecurity,      // it wants a certificate
  kNotShared,     // it listens in another /dev/shm
  kOtherUser,     // it listens in files that are not for this user
  kUnreachable,   // its addresses cannot be reached from here
  kOtherNetwork,  // they can, but not from the interfaces that were told
  kUnknown,
};
Silence silence_of(const Observations& seen, const SeenParticipant& peer);
Peers members_with(const Observations& seen, Silence silence);

// "worker 0a02f28a4c82fd8a".
std::string name_of(const SeenParticipant& peer);
// Of some: "worker 1, worker 2 and 7 more".
std::string names_of(
    const Peers& peers, const std::function<std::string(const SeenParticipant&)>& text =
                            [](const SeenParticipant& peer) { return name_of(peer); });
std::string in_list(const std::vector<std::string>& texts);

// "12.5 MiB"; rounded down.
std::string in_mebibytes(std::uint64_t bytes);

// The domain's ports: multicast, then two for each participant of a machine.
std::uint32_t first_port(const DdsOptions& options);
inline constexpr std::uint32_t kPortsADomain = 250;

}  // namespace accord
