#include "common/transport/fleet/latest_paths.h"

#include <utility>

#include "common/transport/fleet/fleet_limits.h"

namespace accord {
namespace {

constexpr std::size_t kRemembered = 65'536;  // requests

}  // namespace

LatestPaths::LatestPaths(std::size_t most_bytes) : most_bytes_(most_bytes), known_(kRemembered) {}

void LatestPaths::add(const std::shared_ptr<const FinishedPlan>& plan) {
  if (known_.find(plan->id)) return;
  known_.add(plan->id, 1);
  const auto& robots = plan->plan.robots;
  if (robots.empty()) return;
  const std::size_t bytes = memory_of(*plan);
  if (bytes > most_bytes_) return;
  plans_.push_back({plan, bytes});
  bytes_ += bytes;
  for (std::size_t i = 0; i < robots.size(); ++i) latest_[robots[i].name] = {plan, i};
  while (bytes_ > most_bytes_) forget_oldest();
}

void LatestPaths::forget_oldest() {
  const Kept oldest = std::move(plans_.front());
  plans_.pop_front();
  bytes_ -= oldest.bytes;
  for (const RobotPlan& robot : oldest.plan->plan.robots) {
    const auto found = latest_.find(robot.name);
    if (found != latest_.end() && found->second.plan == oldest.plan) latest_.erase(found);
  }
}

LatestPaths::Path LatestPaths::of(const std::string& robot) const {
  const auto found = latest_.find(robot);
  return found == latest_.end() ? Path{} : found->second;
}

}  // namespace accord
