#include "client/doctor/observe.h"

#include <unistd.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "client/doctor/checks/peers.h"
#include "client/doctor/diagnosis.h"
#include "client/doctor/probes/probes.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

// Long enough for those who are there to have been found, and for the service to speak again.
constexpr auto kLeast = 1500ms;
constexpr auto kTurn = 50ms;
// What comes of a datagram to a closed port, or without a route, comes within that.
constexpr auto kForAnswers = 400ms;
// What this process takes of shared memory: it sends next to nothing, and must not be what fills
// it.
constexpr std::size_t kSegment = std::size_t{1} << 20;
constexpr std::uint64_t kRoom = std::uint64_t{4} << 20;

bool has_room(const SharedMemory& memory) {
  return memory.is_usable && memory.free_bytes >= kRoom;
}

// What keeps a participant from joining, where Fast DDS would die of it or not say why.
std::string obstacle(const Observations& seen) {
  const DdsOptions& options = seen.options;
  if (uses_shared_memory(options) && !has_room(seen.memory)) {
    return std::string("not joined: there is no room in ") + kSharedMemoryFolder;
  }
  const auto is_here = [&seen](const std::string& ip) {
    return std::ranges::any_of(seen.interfaces, [&ip](const Interface& interface) {
      return interface.ip == ip && interface.is_up;
    });
  };
  const bool is_kept_out = options.transport != DdsOptions::Transport::kSharedMemory &&
                           !options.interfaces.empty() &&
                           std::ranges::none_of(options.interfaces, is_here);
  return is_kept_out ? "not joined: none of the interfaces is this machine's" : "";
}

DdsOptions as_told(DdsOptions options) {
  options.segment_bytes = kSegment;
  return options;
}

DdsOptions by_udp(DdsOptions options) {
  options.transport = DdsOptions::Transport::kUdp;
  options.discovery = DdsOptions::Discovery::kMulticast;
  options.addresses.clear();
  options.interfaces.clear();
  return options;
}

DdsOptions by_memory(DdsOptions options) {
  options = by_udp(as_told(std::move(options)));
  options.transport = DdsOptions::Transport::kSharedMemory;
  return options;
}

bool says_as_much(const DdsOptions& options) {
  return options.transport == DdsOptions::Transport::kUdp && options.interfaces.empty() &&
         options.discovery == DdsOptions::Discovery::kMulticast;
}

// A participant, or why there is none.
struct Joined {
  std::unique_ptr<DomainWatch> watch;
  std::string fault;

  void join(const DdsOptions& options, SurveyLook look) {
    auto made = make_dds_domain_watch(options, look);
    if (made) {
      watch = std::move(*made);
    } else {
      fault = made.error();
    }
  }
  Look look() const { return {fault, watch ? watch->survey() : DomainSurvey{}}; }
};

bool has_heard_all(const Observations& seen, const DomainSurvey& survey) {
  if (!is_settled(seen.options, survey)) return false;
  if (seen.options.discovery != DdsOptions::Discovery::kServer) return true;
  const auto answered = std::ranges::count_if(
      survey.participants, [](const SeenParticipant& peer) { return peer.server.has_value(); });
  return static_cast<std::size_t>(answered) >= seen.options.addresses.size();
}

void listen(const Observations& seen, DomainWatch* watch, Steady::time_point begun,
            std::chrono::nanoseconds patience, const std::atomic<bool>& stop) {
  while (!stop && Steady::now() - begun < patience) {
    if (watch == nullptr) {
      std::this_thread::sleep_for(kTurn);
      continue;
    }
    watch->listen(kTurn);
    const bool is_soon = Steady::now() - begun < kLeast;
    if (!is_soon && has_heard_all(seen, watch->survey())) return;
  }
}

// Whoever has told nothing of its readers and writers: where it listens, as seen from here.
void look_at_silent(Observations& seen) {
  std::vector<std::pair<std::string, std::unique_ptr<AddressProbes>>> probes;
  for (const SeenParticipant& peer : seen.as_told.survey.participants) {
    if (peer.endpoints > 0 || !peer.name || peer.name->cluster != seen.options.cluster) continue;
    std::vector<DdsAddress> addresses;
    for (const SeenLocator& at : peer.locators) {
      if (at.multicast) continue;
      if (at.kind == SeenLocator::Kind::kSharedMemory) {
        seen.shared_ports.emplace(at.port, look_at_shared_port(at.port));
      } else if (at.kind == SeenLocator::Kind::kUdp && at.port > 0 && at.port <= UINT16_MAX &&
                 addresses.size() < 8) {
        addresses.push_back({at.ip, static_cast<std::uint16_t>(at.port)});
      }
    }
    if (!addresses.empty()) {
      probes.emplace_back(peer.guid, std::make_unique<AddressProbes>(addresses, seen.options));
    }
    if (probes.size() >= 64) break;
  }
  if (probes.empty()) return;
  std::this_thread::sleep_for(kForAnswers);
  for (auto& [guid, probe] : probes) seen.silent[guid] = probe->outcomes();
}

}  // namespace

Observations observe(const DdsOptions& options, const std::string& version,
                     std::chrono::nanoseconds patience, const std::atomic<bool>& stop) {
  Observations seen;
  seen.options = options;
  seen.version = version;
  seen.user = geteuid();
  seen.memory = look_at_shared_memory();
  seen.buffers = look_at_socket_buffers();
  seen.interfaces = look_at_interfaces();
  seen.domains_here = look_at_domains();
  AddressProbes addresses(options.addresses, options);

  const auto begun = Steady::now();
  Joined told, udp, memory;
  told.fault = obstacle(seen);
  if (told.fault.empty()) told.join(as_told(options), SurveyLook::kData);
  if (!says_as_much(options)) udp.join(by_udp(options), SurveyLook::kPresence);
  const bool asks_memory =
      options.transport != DdsOptions::Transport::kSharedMemory && has_room(seen.memory);
  if (asks_memory) memory.join(by_memory(options), SurveyLook::kPresence);

  listen(seen, told.watch.get(), begun, patience, stop);
  seen.listened = std::chrono::duration<double>(Steady::now() - begun).count();
  seen.as_told = told.look();
  if (udp.watch) seen.by_udp = udp.look();
  if (memory.watch) seen.by_memory = memory.look();
  seen.addresses = addresses.outcomes();
  look_at_silent(seen);
  return seen;
}

}  // namespace accord
