// Whether participants of this machine listen where this process can reach them: Fast DDS takes
// shared memory for whoever has the same addresses and has it, too, and never tries UDP beside it.
#include <fmt/format.h>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

std::string with_port(const SeenParticipant& peer) {
  for (const SeenLocator& at : peer.locators) {
    if (at.kind == SeenLocator::Kind::kSharedMemory && !at.multicast) {
      return fmt::format("{} at {}/fastrtps_port{}", name_of(peer), kSharedMemoryFolder, at.port);
    }
  }
  return name_of(peer);
}

std::string with_owner(const Observations& seen, const SeenParticipant& peer) {
  for (const SeenLocator& at : peer.locators) {
    const auto port = seen.shared_ports.find(at.port);
    if (port == seen.shared_ports.end() || port->second.state != SharedPort::State::kDenied) {
      continue;
    }
    return fmt::format("{} at {}/fastrtps_port{}, of user {}", name_of(peer), kSharedMemoryFolder,
                       at.port, port->second.owner);
  }
  return name_of(peer);
}

void check_sharing(const Observations& seen, std::vector<Finding>& out) {
  const Peers apart = members_with(seen, Silence::kNotShared);
  if (apart.empty()) {
    out.push_back(fine(Concern::kShmNotShared, "nobody of this machine listens in another " +
                                                   std::string(kSharedMemoryFolder)));
    return;
  }
  out.push_back(
      {Severity::kFault,
       Concern::kShmNotShared,
       fmt::format("on a machine of these addresses, but not in this {}: {}", kSharedMemoryFolder,
                   names_of(apart, with_port)),
       "Containers on the host's network each have a /dev/shm of their own unless told otherwise. "
       "Their processes find each other, choose shared memory, since all have the host's "
       "addresses, "
       "and nothing ever arrives.",
       {"docker run --ipc=host ...    # all of them, as the same user; ipc: host in a compose file",
        "ACCORD_DDS_TRANSPORT=udp    # for all of them"}});
}

std::vector<std::string> one_user_for_all(std::uint32_t owner) {
  return {fmt::format("setpriv --reuid {} --clear-groups accord-worker    # the same user for all; "
                      "docker run --user {}",
                      owner, owner),
          "ACCORD_DDS_TRANSPORT=udp    # for all of them"};
}

constexpr const char* kClosed =
    "Fast DDS makes shared memory that only its own user may write to, root neither for others nor "
    "others for root. ";

void check_users(const Observations& seen, std::vector<Finding>& out) {
  const Peers foreign = members_with(seen, Silence::kOtherUser);
  if (!foreign.empty()) {
    std::uint32_t owner = 0;
    for (const auto& [number, port] : seen.shared_ports) {
      if (port.state == SharedPort::State::kDenied) owner = port.owner;
    }
    const auto with_its_owner = [&seen](const SeenParticipant& peer) {
      return with_owner(seen, peer);
    };
    out.push_back({Severity::kFault, Concern::kShmOtherUser,
                   fmt::format("not to be opened for writing by user {}: {}", seen.user,
                               names_of(foreign, with_its_owner)),
                   std::string(kClosed) + "Processes find each other, and nothing arrives.",
                   one_user_for_all(owner)});
  } else if (is_shut_out_of_memory(seen)) {
    out.push_back(
        {Severity::kFault, Concern::kShmOtherUser,
         fmt::format("told to use shared memory alone as user {}, and Fast DDS of user {} "
                     "is in {}",
                     seen.user, *seen.memory.other_user, kSharedMemoryFolder),
         std::string(kClosed) + "They do not even find each other.",
         one_user_for_all(*seen.memory.other_user)});
  } else if (leaves_shared_memory(seen)) {
    out.push_back({Severity::kWarning, Concern::kShmOtherUser,
                   fmt::format("Fast DDS of user {} is in {}: what starts now as user {} goes by "
                               "UDP alone",
                               *seen.memory.other_user, kSharedMemoryFolder, seen.user),
                   std::string(kClosed) + "Large messages take longer by UDP.",
                   one_user_for_all(*seen.memory.other_user)});
  } else {
    out.push_back(fine(Concern::kShmOtherUser, "nobody's shared memory is closed to this user"));
  }
}

}  // namespace

void check_shared_ports(const Observations& seen, std::vector<Finding>& out) {
  if (!uses_shared_memory(seen.options) || !seen.as_told.join_fault.empty()) return;
  check_sharing(seen, out);
  check_users(seen, out);
}

}  // namespace accord
