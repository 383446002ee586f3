#include "client/fleet/fleet_manager.h"

#include <algorithm>
#include <utility>

namespace accord {
namespace {

// How long one wait for news lasts at most, so that a stop is heard.
constexpr auto kTurn = std::chrono::milliseconds(20);

}  // namespace

struct FleetManager::Waiting {
  const PlanRequest& request;
  Clock::time_point began = Clock::now();
  Clock::time_point ask_at = Clock::now();
  std::optional<Clock::time_point> stopped;
  bool is_accepted = false;
};

tl::expected<Plan, NoAnswer> FleetManager::plan(const PlanRequest& request, const OnState& on_state,
                                                const std::atomic<bool>& stop) {
  Waiting waiting{request};
  while (true) {
    if (auto answer = take_news(waiting, on_state)) return std::move(*answer);
    const auto now = Clock::now();
    if (stop && !waiting.stopped) {
      waiting.stopped = now;
      waiting.ask_at = now;
    }
    if (waiting.stopped && (!waiting.is_accepted || now - *waiting.stopped > settings_.patience)) {
      static_cast<void>(port_.send(CancelRequest{request.id}));
      return tl::unexpected(NoAnswer{NoAnswer::Why::kStopped});
    }
    if (!waiting.is_accepted && now - waiting.began > settings_.patience) {
      return tl::unexpected(NoAnswer{NoAnswer::Why::kNoService});
    }
    if (now >= waiting.ask_at) ask(waiting);
    port_.wait(std::clamp<Clock::duration>(waiting.ask_at - Clock::now(), Clock::duration(0),
                                           kTurn));
  }
}

// What has not been answered, again. The same request twice is one request.
void FleetManager::ask(Waiting& waiting) {
  const std::string& id = waiting.request.id;
  const FleetRequest next = waiting.stopped       ? FleetRequest(CancelRequest{id})
                            : waiting.is_accepted ? FleetRequest(ResendRequest{id})
                                                  : FleetRequest(waiting.request);
  const bool is_sent = port_.send(next);
  waiting.ask_at = Clock::now() + (is_sent ? settings_.again : kTurn);
}

std::optional<tl::expected<Plan, NoAnswer>> FleetManager::take_news(Waiting& waiting,
                                                                    const OnState& on_state) {
  const std::string& id = waiting.request.id;
  while (auto news = port_.take()) {
    if (auto* reply = std::get_if<RequestReply>(&*news); reply != nullptr && reply->id == id) {
      waiting.ask_at = Clock::now() + settings_.again;
      if (!reply->accepted && reply->reason == Rejection::kUnknownRequest) {
        waiting.is_accepted = false;  // a service without a journal that was started anew
        waiting.began = waiting.ask_at = Clock::now();
      } else if (!reply->accepted) {
        return tl::unexpected(NoAnswer{NoAnswer::Why::kRejected, std::move(*reply)});
      } else {
        waiting.is_accepted = true;
      }
    }
    if (const auto* state = std::get_if<RequestState>(&*news); state != nullptr && state->id == id) {
      waiting.is_accepted = true;
      waiting.ask_at = Clock::now() + settings_.again;
      if (on_state) on_state(*state);
    }
    if (auto* found = std::get_if<FinishedPlan>(&*news); found != nullptr && found->id == id) {
      return std::move(found->plan);
    }
  }
  return std::nullopt;
}

}  // namespace accord
