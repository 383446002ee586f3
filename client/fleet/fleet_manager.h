// A fleet manager's side of planning as a service, in a few calls, over the public topics: submit
// requests, take what becomes of them, cancel them. Messages may get lost and the service may be
// restarted: whatever has not been answered is asked for again.
// Not thread safe.
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "common/model/plan.h"
#include "common/model/plan_request.h"
#include "common/model/request_state.h"
#include "common/transport/fleet/fleet_port.h"

namespace accord {

// Why a request has no plan, not even one that says why there is none.
struct NoAnswer {
  enum class Why {
    kRejected,   // by the service: `reply` says why
    kNoService,  // none has answered within the patience, but for ones that were about to end
  };
  Why why = Why::kNoService;
  RequestReply reply = {};
};

class FleetManager {
 public:
  using Clock = std::chrono::steady_clock;

  struct Settings {
    Clock::duration patience = std::chrono::seconds(10);        // until a service has accepted
    Clock::duration again = std::chrono::milliseconds(500);     // asked again; longer each time, up
    Clock::duration at_most = std::chrono::milliseconds(4000);  // to this
  };

  // The port must outlive this.
  FleetManager(FleetClientPort& port, const Settings& settings)
      : port_(port), settings_(settings) {}

  // The request is on its way; next() tells what becomes of it. Requires: no other request of this
  // id is.
  void submit(PlanRequest request);
  // The request ends as cancelled, if it has not ended otherwise by then. Nothing happens where it
  // is not on its way.
  void cancel(const std::string& id);

  // How far a request has come, or how it ended: then it is on its way no more. A service that has
  // accepted it and falls silent is waited for as long as it takes: what it has accepted it
  // finishes.
  struct Event {
    std::string id;
    std::variant<RequestState, Plan, NoAnswer> what;
  };
  // The next event; waits for it until the timeout ends.
  std::optional<Event> next(Clock::duration timeout);

  // Whether next() has something to tell, now or later.
  bool is_waiting() const { return !waiting_.empty() || !events_.empty(); }

  // Submits one request and waits for its end. `on_state` is called as it comes along. Where
  // `stop` becomes true, it is cancelled.
  tl::expected<Plan, NoAnswer> plan(PlanRequest request,
                                    const std::function<void(const RequestState&)>& on_state,
                                    const std::atomic<bool>& stop);

 private:
  struct Waiting {
    PlanRequest request;
    Clock::time_point since;
    Clock::time_point ask_at;
    Clock::duration again;
    bool is_sent = false;  // once at least
    bool is_accepted = false;
    bool is_cancelled = false;
  };

  void take_news();
  void on_reply(Waiting& waiting, RequestReply reply);
  void ask(Waiting& waiting, Clock::time_point now);
  void end(const std::string& id, std::variant<RequestState, Plan, NoAnswer> how);
  void heard_of(Waiting& waiting);

  FleetClientPort& port_;
  Settings settings_;
  std::map<std::string, Waiting> waiting_;
  std::deque<Event> events_;
};

}  // namespace accord
