#include "client/fleet/fleet_manager.h"

#include <algorithm>
#include <utility>

namespace accord {
namespace {

// How soon what could not be sent is tried again.
constexpr auto kRetry = std::chrono::milliseconds(20);

}  // namespace

void FleetManager::submit(PlanRequest request) {
  const auto now = Clock::now();
  std::string id = request.id;
  waiting_[std::move(id)] =
      Waiting{std::move(request), now, now, settings_.again, false, false, false};
}

void FleetManager::cancel(const std::string& id) {
  const auto found = waiting_.find(id);
  if (found == waiting_.end() || std::exchange(found->second.is_cancelled, true)) return;
  found->second.ask_at = Clock::now();
  found->second.again = settings_.again;
}

std::optional<FleetManager::Event> FleetManager::next(Clock::duration timeout) {
  const auto until = Clock::now() + timeout;
  while (true) {
    take_news();
    const auto now = Clock::now();
    auto wake = until;
    std::vector<std::string> given_up;
    for (auto& [id, waiting] : waiting_) {
      if (!waiting.is_accepted && now - waiting.since > settings_.patience) {
        given_up.push_back(id);
      } else if (now >= waiting.ask_at) {
        ask(waiting, now);
      }
      wake = std::min(wake, waiting.ask_at);
    }
    for (const std::string& id : given_up) end(id, NoAnswer{});
    if (!events_.empty()) {
      Event event = std::move(events_.front());
      events_.pop_front();
      return event;
    }
    if (now >= until) return std::nullopt;
    if (wake > now) port_.wait(wake - now);
  }
}

// What has not been answered, again. The same request twice is one request.
void FleetManager::ask(Waiting& waiting, Clock::time_point now) {
  const std::string& id = waiting.request.id;
  const bool is_sent = waiting.is_cancelled && waiting.is_accepted ? port_.send(CancelRequest{id})
                       : waiting.is_accepted                       ? port_.send(ResendRequest{id})
                                                                   : port_.send(waiting.request);
  waiting.is_sent |= is_sent;
  waiting.ask_at = now + (is_sent ? waiting.again : Clock::duration(kRetry));
  if (is_sent) waiting.again = std::min(2 * waiting.again, settings_.at_most);
}

// Of a request that has not been sent yet, only an earlier one's news can have come, which had the
// same id: who joins late hears of what was. The service has to say whether they are the same.
void FleetManager::take_news() {
  while (auto news = port_.take()) {
    if (auto* reply = std::get_if<RequestReply>(&*news)) {
      const auto found = waiting_.find(reply->id);
      if (found != waiting_.end()) on_reply(found->second, std::move(*reply));
    } else if (auto* state = std::get_if<RequestState>(&*news)) {
      const auto found = waiting_.find(state->id);
      if (found == waiting_.end() || !found->second.is_sent) continue;
      found->second.is_accepted = true;
      heard_of(found->second);
      events_.push_back({state->id, std::move(*state)});
    } else if (auto* finished = std::get_if<FinishedPlan>(&*news)) {
      const auto found = waiting_.find(finished->id);
      if (found == waiting_.end() || !found->second.is_sent) continue;
      end(finished->id, std::move(finished->plan));
    }
  }
}

void FleetManager::on_reply(Waiting& waiting, RequestReply reply) {
  if (reply.accepted) {
    const bool is_first = !std::exchange(waiting.is_accepted, true);
    heard_of(waiting);
    if (is_first && waiting.is_cancelled) waiting.ask_at = Clock::now();
  } else if (reply.reason == Rejection::kUnknownRequest) {
    // The answer to a question of ours: a service without a journal was started anew, or ours was
    // on its way still.
    waiting.is_accepted = false;
    waiting.since = waiting.ask_at = Clock::now();
    waiting.again = settings_.again;
  } else if (reply.reason == Rejection::kShuttingDown) {
    // Another one may come, and within the patience it is waited for.
    heard_of(waiting);
  } else {
    const std::string id = reply.id;
    end(id, NoAnswer{NoAnswer::Why::kRejected, std::move(reply)});
  }
}

void FleetManager::heard_of(Waiting& waiting) {
  waiting.ask_at = Clock::now() + waiting.again;
}

void FleetManager::end(const std::string& id, std::variant<RequestState, Plan, NoAnswer> how) {
  events_.push_back({id, std::move(how)});
  waiting_.erase(id);
}

tl::expected<Plan, NoAnswer> FleetManager::plan(
    PlanRequest request, const std::function<void(const RequestState&)>& on_state,
    const std::atomic<bool>& stop) {
  constexpr auto kTurn = std::chrono::milliseconds(20);
  const std::string id = request.id;
  submit(std::move(request));
  while (true) {
    if (stop) cancel(id);
    auto event = next(kTurn);
    if (!event || event->id != id) continue;
    if (const auto* state = std::get_if<RequestState>(&event->what)) {
      if (on_state) on_state(*state);
    } else if (auto* plan = std::get_if<Plan>(&event->what)) {
      return std::move(*plan);
    } else {
      return tl::unexpected(std::move(std::get<NoAnswer>(event->what)));
    }
  }
}

}  // namespace accord
