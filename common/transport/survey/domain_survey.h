// Who is in a DDS domain, and what of it reaches this process: what `accord doctor` looks at. Plain
// values, as the network said them: names and topics are whatever somebody sent.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "common/transport/dds_options.h"
#include "common/transport/fleet/fleet_messages.h"

namespace accord {

// Where a participant listens, as far as its messages could be sent there from here: Fast DDS keeps
// nothing else of what it is told. Participants of this machine that have shared memory, as this
// one has, are kept with that alone.
struct SeenLocator {
  enum class Kind { kUdp, kSharedMemory, kOther };
  Kind kind = Kind::kUdp;
  std::string ip;  // of UDP
  std::uint32_t port = 0;
  bool multicast = false;

  friend auto operator<=>(const SeenLocator&, const SeenLocator&) = default;
};

// What a participant of Accord says of itself before any message.
struct AccordName {
  enum class Role { kCoordinator, kWorker, kService, kClient, kDoctor, kOther };
  Role role = Role::kOther;  // the first two are on the bus, all others on the public topics
  std::string cluster;
  std::uint32_t protocol = 0;
  std::uint64_t id = 0;  // of those on the bus

  friend bool operator==(const AccordName&, const AccordName&) = default;
};

// "accord/CLUSTER/PROTOCOL/worker/ID" or "accord-fleet/CLUSTER/VERSION/service"; nullopt for
// others. Takes any bytes.
std::optional<AccordName> accord_name_in(const std::string& user_data);

struct SeenParticipant {
  std::string guid;                   // 24 hexadecimal digits
  std::string host;                   // the first 8 of them; of Fast DDS, the same for one machine
  bool is_fast_dds = false;           // others number their machines in other ways
  bool is_of_this_host = false;       // as Fast DDS tells: the same addresses
  bool demands_security = false;      // it shows a certificate, and wants to see one
  std::optional<std::size_t> server;  // which of the discovery servers that were asked for
  std::optional<AccordName> name;     // nullopt: not of Accord
  std::set<SeenLocator> locators;
  // Of its readers and writers, once it has told of them, which it does to this process's own
  // address.
  std::size_t endpoints = 0;
  std::set<std::string> topics;      // at most kSeenTopics
  std::set<std::string> partitions;  // at most kSeenTopics
  std::size_t matches = 0;           // with readers of this process
  std::size_t samples = 0;           // that came from it
  // How far its clock is ahead of this machine's (s), from messages that were sent while this
  // process listened; what they took on their way is taken off. nullopt: none came.
  std::optional<double> clock_ahead;
};

inline constexpr std::size_t kSeenParticipants = 1000;  // further ones are passed over
inline constexpr std::size_t kSeenTopics = 64;

struct DomainSurvey {
  std::vector<SeenParticipant> participants;  // by guid; without those that have gone
  std::optional<ServiceStatus> service;       // the latest that came
  std::vector<WorkerStatus> workers;          // the latest of each
};

// What a survey is for.
enum class SurveyLook {
  kData,      // reads what the service and its workers say, as far as it reaches here
  kPresence,  // only looks who is there
};

// Thread safety: one thread calls everything.
class DomainWatch {
 public:
  virtual ~DomainWatch() = default;
  // Waits until something has come or the timeout has ended.
  virtual void listen(std::chrono::nanoseconds timeout) = 0;
  virtual DomainSurvey survey() const = 0;
};

// Joins a domain, or says in a sentence why it could not. It takes nothing from anybody: whoever is
// there goes on as before. Those who do the same are not among the participants that it sees.
tl::expected<std::unique_ptr<DomainWatch>, std::string> make_dds_domain_watch(
    const DdsOptions& options, SurveyLook look);

}  // namespace accord
