// What is said about a request on its way from submission to plan. Numbers are part of the public
// topics (idl/fleet.idl): they never change their meaning.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace accord {

// Why a request is not accepted.
enum class Rejection : std::uint16_t {
  kNone = 0,
  kBadId = 1,            // the id: empty, too long, or with other characters than it may have
  kIdInUse = 2,          // another request has this id
  kBadScene = 3,         // the scene is wrong, or a file that it names is not attached
  kUnknownScene = 4,     // no scene of that name is in store
  kBadQuery = 5,         // an unknown robot, or a start or goal that it cannot have
  kBadOption = 6,        // method, solvers, deadline
  kTooLarge = 7,         // beyond one of the service's limits
  kQueueFull = 8,        // as many requests as the service holds are waiting
  kNoJournal = 9,        // the journal cannot be written, so it could get lost
  kShuttingDown = 10,    // the service is about to end
  kUnknownRequest = 11,  // said again or cancelled cannot be what nobody knows
};
std::string_view to_string(Rejection reason);

enum class RequestPhase : std::uint8_t {
  kQueued = 0,        // accepted
  kInitialPaths = 1,  // each robot's own path
  kConflicts = 2,     // resolving conflicts between paths
  kProof = 3,         // the verifier at work
  kFinished = 4,      // its plan is there, or the reason why there is none
};
std::string_view to_string(RequestPhase phase);

// How far a request has come.
struct RequestState {
  std::string id;
  RequestPhase phase = RequestPhase::kQueued;
  std::uint32_t ahead = 0;  // requests that are begun before it
  std::uint32_t robots = 0;
  std::uint32_t robots_planned = 0;   // own paths found
  std::uint64_t conflicts_found = 0;  // so far
  std::uint64_t conflicts_resolved = 0;
  std::uint64_t rounds = 0;
  double elapsed = 0;    // s, since it was accepted; of a finished one, until it was finished
  double per_cent = 0;   // 0 to 100, of the work, as well as known; never falls
  double best_cost = 0;  // s, sum of costs of the best paths so far; 0: there are none

  friend bool operator==(const RequestState&, const RequestState&) = default;
};

}  // namespace accord
