#include "client/fleet/cancellation.h"

#include <algorithm>
#include <utility>

namespace accord {
namespace {

// How soon what could not be sent is tried again.
constexpr auto kRetry = std::chrono::milliseconds(20);

}  // namespace

Cancellation::Cancellation(FleetClientPort& port, const std::vector<std::string>& ids,
                           const FleetManager::Settings& settings)
    : port_(port), settings_(settings), heard_(Clock::now()) {
  for (const std::string& id : ids) waiting_[id] = Waiting{heard_, settings_.again};
}

std::optional<Cancellation::End> Cancellation::next(Clock::duration timeout) {
  const auto until = Clock::now() + timeout;
  while (true) {
    take_news();
    const auto now = Clock::now();
    if (now - heard_ > settings_.patience) {
      while (!waiting_.empty()) end(std::string(waiting_.begin()->first), NoAnswer{});
    }
    if (!ends_.empty()) {
      End out = std::move(ends_.front());
      ends_.pop_front();
      return out;
    }
    const auto wake = std::min({until, ask(now), heard_ + settings_.patience});
    if (now >= until || waiting_.empty()) return std::nullopt;
    if (wake > now) port_.wait(wake - now);
  }
}

// What is due; when something will be.
Cancellation::Clock::time_point Cancellation::ask(Clock::time_point now) {
  auto next = Clock::time_point::max();
  for (auto& [id, waiting] : waiting_) {
    if (now >= waiting.ask_at) {
      const bool is_sent = port_.send(CancelRequest{id});
      waiting.ask_at = now + (is_sent ? waiting.again : Clock::duration(kRetry));
      if (is_sent) waiting.again = std::min(2 * waiting.again, settings_.at_most);
    }
    next = std::min(next, waiting.ask_at);
  }
  return next;
}

void Cancellation::take_news() {
  while (auto news = port_.take()) {
    heard_ = Clock::now();
    if (auto* finished = std::get_if<FinishedPlan>(&*news)) {
      end(finished->id, std::move(finished->plan));
    } else if (auto* reply = std::get_if<RequestReply>(&*news)) {
      // A service that is about to end leaves it to the next one, which is waited for.
      if (reply->accepted || reply->reason == Rejection::kShuttingDown) continue;
      const std::string id = reply->id;
      end(id, NoAnswer{NoAnswer::Why::kRejected, std::move(*reply)});
    }
  }
}

void Cancellation::end(const std::string& id, std::variant<Plan, NoAnswer> how) {
  if (waiting_.erase(id) != 0) ends_.push_back({id, std::move(how)});
}

}  // namespace accord
