#include "common/transport/fleet/checked_service.h"

#include <utility>

#include "common/transport/fleet/fleet_limits.h"

namespace accord {

std::optional<FleetRequest> CheckedService::take() {
  auto request = do_take();
  while (request) {
    auto fault = fleet_fault(*request);
    if (!fault) break;
    ++beyond_limits_;
    refuse(*request, std::move(*fault));
    request = do_take();
  }
  if (request) ++counters_.received;
  counters_.malformed = unreadable() + beyond_limits_;
  counters_.topics = traffic();
  return request;
}

// Who asks for a plan with a program of its own may not know of our limits.
void CheckedService::refuse(const FleetRequest& request, std::string fault) {
  const auto* plan = std::get_if<PlanRequest>(&request);
  if (plan == nullptr) return;
  publish(RequestReply{plan->id, false, Rejection::kTooLarge, {}, std::move(fault)});
}

void CheckedService::publish(const FleetNews& news) {
  const bool sent = !fleet_fault(news) && do_publish(news);
  ++(sent ? counters_.sent : counters_.unsent);
}

}  // namespace accord
