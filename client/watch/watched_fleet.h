// What a service has said of itself, its requests and its workers, as far as it is still so.
// Memory is bounded: what ended longest ago is forgotten first.
// Not thread safe.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/transport/fleet/fleet_messages.h"

namespace accord {

// Of a clock that does not go back.
using WatchTime = std::chrono::nanoseconds;

struct WatchedRequest {
  // A plan but for the robots' paths.
  struct Outcome {
    PlanStatus status = PlanStatus::kInvalid;
    std::string message;
    double makespan = 0;  // s
  };
  RequestState state;
  std::optional<Outcome> outcome;  // perhaps that of an older request of this id, until it ends
  WatchTime heard{0};

  bool is_finished() const { return state.phase == RequestPhase::kFinished; }
  // s, since it was accepted.
  double elapsed(WatchTime now) const;
};

struct WatchedWorker {
  WorkerStatus status;
  WatchTime since{0};  // known
  WatchTime heard{0};
};

struct WatchedService {
  ServiceStatus status;
  bool is_present = false;
  WatchTime heard{0};

  double uptime(WatchTime now) const;
};

class WatchedFleet {
 public:
  static constexpr std::size_t kRequests = 4096;
  static constexpr std::size_t kWorkers = 4096;
  static constexpr std::size_t kFinished = 1000;  // requests

  using Change = std::variant<WatchedRequest, WatchedWorker, WatchedService>;

  // What has changed by this; nullopt where it says nothing new, but for the time that has passed.
  std::optional<Change> take(FleetNews news, WatchTime now);
  // Whether a service is there. Requires: the same of every call, from whoever knows (the port).
  std::optional<Change> set_present(bool is_present, WatchTime now);
  // Forgets workers that are gone, and requests that the service says that it has no more.
  void forget(WatchTime now);

  // nullopt: none has been heard yet.
  const std::optional<WatchedService>& service() const { return service_; }
  // Those that are planned, the oldest first; those that wait, as they are begun; those that have
  // ended, the latest first.
  std::vector<const WatchedRequest*> requests(WatchTime now) const;
  // By host and process; those that are lost last.
  std::vector<const WatchedWorker*> workers() const;

  // Whether all workers and unfinished requests are known that the service says that there are.
  bool is_complete() const;

 private:
  std::optional<Change> take_state(RequestState state, WatchTime now);
  std::optional<Change> take_outcome(const FinishedPlan& finished, WatchTime now);
  std::optional<Change> take_worker(WorkerStatus status, WatchTime now);
  std::optional<Change> take_service(ServiceStatus status, WatchTime now);
  std::size_t unfinished() const;
  std::size_t unfinished_said() const;
  void keep_requests_few();

  std::optional<WatchedService> service_;
  bool is_found_ = false;
  std::map<std::string, WatchedRequest> requests_;
  std::map<std::uint64_t, WatchedWorker> workers_;
};

}  // namespace accord
