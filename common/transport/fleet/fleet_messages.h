// What fleet managers and the service say to each other on the public topics: plain values. The
// wire's counterparts are in idl/fleet.idl.
//
// Everything may come twice, late or not at all, so all of it says which request it is about and
// can be asked for again.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "common/model/plan.h"
#include "common/model/plan_request.h"
#include "common/model/request_state.h"
#include "common/model/scene.h"

namespace accord {

// ---- Fleet manager to service: PlanRequest, and ----

struct CancelRequest {
  std::string id;
  friend bool operator==(const CancelRequest&, const CancelRequest&) = default;
};

// Say again how a request stands: its reply, its state and, where it is finished, its plan.
struct ResendRequest {
  std::string id;
  friend bool operator==(const ResendRequest&, const ResendRequest&) = default;
};

using FleetRequest = std::variant<PlanRequest, CancelRequest, ResendRequest>;

// ---- Service to fleet managers ----

struct RequestReply {
  std::string id;
  bool accepted = false;
  Rejection reason = Rejection::kNone;
  std::string field;  // where the fault is, as in robots[4].goal; empty: the request as a whole
  std::string text;   // what is wrong and what was expected, for people

  friend bool operator==(const RequestReply&, const RequestReply&) = default;
};

// The outcome of a request, whole: ports cut it into bounded pieces and put it together again.
struct FinishedPlan {
  std::string id;
  Plan plan;
  // What it was planned for; null where that is not at hand any more. Does not travel.
  std::shared_ptr<const Scene> scene = {};
  // The hash of what was asked, in hexadecimal digits: of requests that ask for the same, the same.
  std::string content = {};
};

struct WorkerStatus {
  std::uint64_t worker = 0;  // its endpoint
  std::string host;
  std::uint32_t process = 0;
  std::string version;
  std::uint32_t threads = 0;
  std::uint32_t busy = 0;  // tasks that it has in hand
  std::string standing;    // "welcome", "leaving", "refused", "distrusted", "lost"
  std::string text;        // why, where it is none of the first two

  friend bool operator==(const WorkerStatus&, const WorkerStatus&) = default;
};

struct ServiceStatus {
  std::string version;
  std::string host;
  std::uint32_t process = 0;
  double uptime = 0;  // s
  std::uint32_t workers = 0;
  std::uint32_t threads = 0;  // of theirs
  std::uint32_t queued = 0;   // requests
  std::uint32_t planning = 0;
  std::uint64_t finished = 0;  // since it was started
  bool accepting = true;       // else it drains

  friend bool operator==(const ServiceStatus&, const ServiceStatus&) = default;
};

using FleetNews =
    std::variant<RequestReply, RequestState, FinishedPlan, WorkerStatus, ServiceStatus>;

}  // namespace accord
