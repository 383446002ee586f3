// A fleet manager's side of planning as a service, in a few calls, over the public topics: submit a
// request, wait for its plan, cancel it. Messages may get lost and the service may be restarted:
// whatever has not been answered is asked for again.
// Not thread safe.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "common/model/plan.h"
#include "common/model/plan_request.h"
#include "common/model/request_state.h"
#include "common/transport/fleet/fleet_port.h"

namespace accord {

// Why there is no answer.
struct NoAnswer {
  enum class Why {
    kRejected,   // by the service: `reply` says why
    kNoService,  // none has answered within the patience
    kStopped,    // by the caller
  };
  Why why = Why::kNoService;
  RequestReply reply = {};
};

class FleetManager {
 public:
  using Clock = std::chrono::steady_clock;

  struct Settings {
    Clock::duration patience = std::chrono::seconds(10);      // with a service that does not answer
    Clock::duration again = std::chrono::milliseconds(500);  // asked again, unanswered
  };

  // The port must outlive this.
  FleetManager(FleetClientPort& port, const Settings& settings) : port_(port), settings_(settings) {}

  using OnState = std::function<void(const RequestState&)>;

  // Submits a request and waits for its plan, which may be one that says why there is none.
  // `on_state` is called from this thread as the request comes along. Where `stop` becomes true,
  // the request is cancelled, and what the service says then is the answer, or kStopped where it
  // says nothing within the patience.
  // A service that falls silent on the way is waited for as long as it takes: what it has accepted
  // it finishes.
  tl::expected<Plan, NoAnswer> plan(const PlanRequest& request, const OnState& on_state,
                                    const std::atomic<bool>& stop);

 private:
  struct Waiting;
  std::optional<tl::expected<Plan, NoAnswer>> take_news(Waiting& waiting, const OnState& on_state);
  void ask(Waiting& waiting);

  FleetClientPort& port_;
  Settings settings_;
};

}  // namespace accord
