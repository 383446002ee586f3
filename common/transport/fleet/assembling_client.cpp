#include "common/transport/fleet/assembling_client.h"

#include <algorithm>
#include <string>
#include <utility>

#include "common/transport/fleet/fleet_limits.h"

namespace accord {
namespace {

PlanAssembly::Time now() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace

bool AssemblingClient::send(const FleetRequest& request) {
  if (!wants_paths_ && std::holds_alternative<PlanRequest>(request)) return false;
  if (fleet_fault(request) || !has_service() || !do_send(request)) return false;
  ++counters_.sent;
  if (!wants_paths_) return true;
  if (const auto* plan = std::get_if<PlanRequest>(&request)) assembly_.expect(plan->id);
  if (const auto* resend = std::get_if<ResendRequest>(&request)) assembly_.expect(resend->id);
  return true;
}

std::optional<FleetNews> AssemblingClient::take() {
  std::optional<FleetNews> news;
  while (!news) {
    auto part = do_take();
    drained_ = !part;
    if (!part) break;
    if (fleet_fault(*part)) {
      ++beyond_limits_;
    } else {
      news = news_of(std::move(*part));
    }
  }
  if (news) ++counters_.received;
  counters_.malformed = unreadable() + beyond_limits_ + assembly_.malformed();
  ask_again();
  return news;
}

std::optional<FleetNews> AssemblingClient::news_of(FleetPart part) {
  if (auto* outline = std::get_if<PlanOutline>(&part)) {
    if (!wants_paths_) {
      return FinishedPlan{std::move(outline->id), std::move(outline->plan), nullptr,
                          std::move(outline->content)};
    }
    return assembly_.add(std::move(*outline), now());
  }
  if (auto* piece = std::get_if<PathPiece>(&part)) {
    if (!wants_paths_) return std::nullopt;
    return assembly_.add(std::move(*piece), now());
  }
  if (auto* state = std::get_if<RequestState>(&part)) {
    if (state->phase == RequestPhase::kFinished) assembly_.note_finished(state->id, now());
    return std::move(*state);
  }
  if (auto* reply = std::get_if<RequestReply>(&part)) return std::move(*reply);
  if (auto* worker = std::get_if<WorkerStatus>(&part)) return std::move(*worker);
  return std::get<ServiceStatus>(std::move(part));
}

void AssemblingClient::wait(std::chrono::nanoseconds timeout) {
  if (!drained_) return;
  // While there is nobody to ask, nothing is overdue.
  const auto due = has_service() ? assembly_.next_overdue() : std::nullopt;
  if (due) timeout = std::min(timeout, *due - now());
  do_wait(std::max(timeout, std::chrono::nanoseconds(0)));
  ask_again();
}

void AssemblingClient::ask_again() {
  if (!has_service()) return;
  for (std::string& id : assembly_.overdue(now())) do_send(ResendRequest{std::move(id)});
}

}  // namespace accord
