#include "client/doctor/checks/peers.h"

#include <fmt/format.h>

#include <algorithm>

namespace accord {
namespace {

constexpr std::size_t kNamed = 5;

bool listens_in_memory_only(const SeenParticipant& peer) {
  return !peer.locators.empty() && std::ranges::all_of(peer.locators, [](const SeenLocator& at) {
    return at.kind == SeenLocator::Kind::kSharedMemory;
  });
}

// Participants in different /dev/shm number their ports alike; then one of them is there, but not
// the other's.
bool is_claimed_by_others(const Observations& seen, const SeenParticipant& peer,
                          std::uint32_t port) {
  return std::ranges::any_of(seen.as_told.survey.participants, [&](const SeenParticipant& other) {
    return other.guid != peer.guid &&
           std::ranges::any_of(other.locators, [port](const SeenLocator& at) {
             return at.kind == SeenLocator::Kind::kSharedMemory && at.port == port && !at.multicast;
           });
  });
}

Silence silence_in_memory(const Observations& seen, const SeenParticipant& peer) {
  bool is_denied = false;
  for (const SeenLocator& at : peer.locators) {
    const auto port = seen.shared_ports.find(at.port);
    if (at.multicast || port == seen.shared_ports.end()) continue;
    if (port->second.state == SharedPort::State::kMissing ||
        port->second.state == SharedPort::State::kOwn ||
        is_claimed_by_others(seen, peer, at.port)) {
      return Silence::kNotShared;
    }
    is_denied |= port->second.state == SharedPort::State::kDenied;
  }
  return is_denied ? Silence::kOtherUser : Silence::kUnknown;
}

// A socket that is kept to one interface hears multicast from all of them, so that announcements
// arrive of whom no answer can reach.
bool is_reached_from_other_interfaces(const Observations& seen, const SeenParticipant& peer) {
  if (seen.options.interfaces.empty() || !seen.by_udp) return false;
  return std::ranges::any_of(seen.by_udp->survey.participants, [&peer](const auto& other) {
    return other.guid == peer.guid && is_reached(other);
  });
}

bool is_unreachable(const AddressProbe& probe) {
  return !probe.fault.empty() || (probe.ports > 0 && probe.refused == probe.ports);
}

}  // namespace

bool leaves_shared_memory(const Observations& seen) {
  return seen.options.transport == DdsOptions::Transport::kBoth && seen.memory.other_user;
}

bool is_shut_out_of_memory(const Observations& seen) {
  return seen.options.transport == DdsOptions::Transport::kSharedMemory && seen.memory.other_user &&
         members(seen, seen.as_told.survey).empty();
}

bool uses_shared_memory(const DdsOptions& options) {
  return options.transport != DdsOptions::Transport::kUdp;
}

bool uses_udp(const DdsOptions& options) {
  return options.transport != DdsOptions::Transport::kSharedMemory;
}

Peers members(const Observations& seen, const DomainSurvey& survey) {
  Peers out;
  for (const SeenParticipant& peer : survey.participants) {
    const bool is_member = peer.name && peer.name->cluster == seen.options.cluster &&
                           peer.name->role != AccordName::Role::kClient;
    if (is_member) out.push_back(&peer);
  }
  return out;
}

bool speaks_our_protocol(const Observations& seen, const AccordName& name) {
  constexpr std::uint32_t kFleetVersion = 1;
  const bool is_on_bus =
      name.role == AccordName::Role::kCoordinator || name.role == AccordName::Role::kWorker;
  return name.protocol == (is_on_bus ? seen.options.protocol : kFleetVersion);
}

bool is_reached(const SeenParticipant& peer) {
  return peer.endpoints > 0 || peer.samples > 0;
}

Silence silence_of(const Observations& seen, const SeenParticipant& peer) {
  if (is_reached(peer)) return Silence::kNone;
  if (peer.demands_security) return Silence::kSecurity;
  if (peer.is_of_this_host && listens_in_memory_only(peer)) return silence_in_memory(seen, peer);
  if (is_reached_from_other_interfaces(seen, peer)) return Silence::kOtherNetwork;
  const auto probes = seen.silent.find(peer.guid);
  const bool has_way = probes == seen.silent.end() || probes->second.empty() ||
                       !std::ranges::all_of(probes->second, is_unreachable);
  return has_way ? Silence::kUnknown : Silence::kUnreachable;
}

Peers members_with(const Observations& seen, Silence silence) {
  Peers out = members(seen, seen.as_told.survey);
  std::erase_if(out,
                [&](const SeenParticipant* peer) { return silence_of(seen, *peer) != silence; });
  return out;
}

std::string name_of(const SeenParticipant& peer) {
  if (!peer.name) return "participant " + peer.guid;
  switch (peer.name->role) {
    case AccordName::Role::kCoordinator:
      return fmt::format("coordinator {:016x}", peer.name->id);
    case AccordName::Role::kWorker:
      return fmt::format("worker {:016x}", peer.name->id);
    case AccordName::Role::kService:
      return "service " + peer.guid;
    case AccordName::Role::kClient:
      return "client " + peer.guid;
    case AccordName::Role::kDoctor:
    case AccordName::Role::kOther:
      break;
  }
  return "participant " + peer.guid;
}

std::string names_of(const Peers& peers,
                     const std::function<std::string(const SeenParticipant&)>& text) {
  std::vector<std::string> texts;
  for (const SeenParticipant* peer : peers) texts.push_back(text(*peer));
  return in_list(texts);
}

std::string in_list(const std::vector<std::string>& texts) {
  const bool is_cut = texts.size() > kNamed;
  const std::size_t named = is_cut ? kNamed - 1 : texts.size();
  std::string out;
  for (std::size_t i = 0; i < named; ++i) {
    const bool is_last = !is_cut && i + 1 == named;
    out += i == 0 ? "" : is_last ? " and " : ", ";
    out += texts[i];
  }
  return is_cut ? fmt::format("{} and {} more", out, texts.size() - named) : out;
}

std::string in_mebibytes(std::uint64_t bytes) {
  constexpr std::uint64_t kTenths = (std::uint64_t{1} << 20) / 10;
  return fmt::format("{}.{} MiB", bytes / kTenths / 10, bytes / kTenths % 10);
}

std::uint32_t first_port(const DdsOptions& options) {
  constexpr std::uint32_t kBase = 7400;
  return kBase + kPortsADomain * options.domain;
}

}  // namespace accord
