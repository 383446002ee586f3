#include "client/watch/watched_fleet.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace accord {
namespace {

using namespace std::chrono_literals;

// The service says all of its workers, and itself, every 2 s.
constexpr WatchTime kSilence = 7s;         // until a worker, of which it says nothing more, is gone
constexpr WatchTime kUnheardRequest = 4s;  // until one may be among those that it has no more
constexpr WatchTime kLostShown = 10s;      // a worker that is lost, and was there before
constexpr WatchTime kThereBefore = 1s;     // else it is one of the past, told to who comes late

constexpr std::string_view kLost = "lost";

double seconds(WatchTime time) {
  return std::chrono::duration<double>(time).count();
}

// The same but for the time that has passed.
bool says_the_same(RequestState a, const RequestState& b) {
  a.elapsed = b.elapsed;
  return a == b;
}
bool says_the_same(ServiceStatus a, const ServiceStatus& b) {
  a.uptime = b.uptime;
  return a == b;
}

}  // namespace

double WatchedRequest::elapsed(WatchTime now) const {
  return state.elapsed + (is_finished() ? 0 : seconds(now - heard));
}

double WatchedService::uptime(WatchTime now) const {
  return status.uptime + (is_present ? seconds(now - heard) : 0);
}

std::optional<WatchedFleet::Change> WatchedFleet::take(FleetNews news, WatchTime now) {
  if (auto* state = std::get_if<RequestState>(&news)) return take_state(std::move(*state), now);
  if (auto* plan = std::get_if<FinishedPlan>(&news)) return take_outcome(*plan, now);
  if (auto* worker = std::get_if<WorkerStatus>(&news)) return take_worker(std::move(*worker), now);
  if (auto* status = std::get_if<ServiceStatus>(&news))
    return take_service(std::move(*status), now);
  return std::nullopt;  // replies are for who has asked
}

std::optional<WatchedFleet::Change> WatchedFleet::take_state(RequestState state, WatchTime now) {
  const auto [place, is_new] = requests_.try_emplace(state.id);
  WatchedRequest& request = place->second;
  const bool is_same = !is_new && says_the_same(state, request.state);
  // What comes twice has not grown older meanwhile.
  if (!is_same || !request.is_finished()) request.heard = now;
  request.state = std::move(state);
  WatchedRequest changed = request;
  if (is_new) keep_requests_few();
  if (is_same) return std::nullopt;
  return changed;
}

std::optional<WatchedFleet::Change> WatchedFleet::take_outcome(const FinishedPlan& finished,
                                                               WatchTime now) {
  const Plan& plan = finished.plan;
  const auto [place, is_new] = requests_.try_emplace(finished.id);
  WatchedRequest& request = place->second;
  if (is_new) {
    request.state.id = finished.id;
    request.state.phase = RequestPhase::kFinished;
    request.state.robots = static_cast<std::uint32_t>(plan.robots.size());
    request.state.elapsed = plan.planning_time;
    request.heard = now;
  }
  const bool is_same = request.outcome && request.outcome->status == plan.status &&
                       request.outcome->message == plan.message &&
                       request.outcome->makespan == plan.makespan;
  request.outcome = {plan.status, plan.message, plan.makespan};
  WatchedRequest changed = request;
  if (is_new) keep_requests_few();
  if (is_same || !changed.is_finished()) return std::nullopt;
  return changed;
}

std::optional<WatchedFleet::Change> WatchedFleet::take_worker(WorkerStatus status, WatchTime now) {
  const auto known = workers_.find(status.worker);
  if (known == workers_.end()) {
    if (status.standing == kLost || workers_.size() >= kWorkers) return std::nullopt;
    const std::uint64_t id = status.worker;
    return workers_[id] = {std::move(status), now, now};
  }
  WatchedWorker& worker = known->second;
  worker.heard = now;
  if (status == worker.status) return std::nullopt;
  worker.status = std::move(status);
  WatchedWorker changed = worker;
  if (changed.status.standing == kLost && now - worker.since < kThereBefore) {
    workers_.erase(known);
    return std::nullopt;
  }
  return changed;
}

std::optional<WatchedFleet::Change> WatchedFleet::take_service(ServiceStatus status,
                                                               WatchTime now) {
  const bool is_same = service_ && service_->is_present && says_the_same(status, service_->status);
  service_ = {std::move(status), true, now};
  return is_same ? std::nullopt : std::optional<Change>(*service_);
}

std::optional<WatchedFleet::Change> WatchedFleet::set_present(bool is_present, WatchTime now) {
  // The first word may come before it counts as there; it is gone only if it was. And one that has
  // said nothing yet is not there for who watches.
  const bool was_found = std::exchange(is_found_, is_present);
  if (!service_ || !service_->is_present || is_present || !was_found) return std::nullopt;
  service_->status.uptime = service_->uptime(now);
  service_->heard = now;
  service_->is_present = false;
  return *service_;
}

void WatchedFleet::forget(WatchTime now) {
  if (!service_ || !service_->is_present) return;  // nobody says anything
  std::erase_if(workers_, [now](const auto& entry) {
    const WatchedWorker& worker = entry.second;
    return now - worker.heard > (worker.status.standing == kLost ? kLostShown : kSilence);
  });
  // Their end was missed, or the service was started anew without a journal.
  std::size_t known = unfinished();
  while (known > unfinished_said()) {
    auto oldest = requests_.end();
    for (auto request = requests_.begin(); request != requests_.end(); ++request) {
      if (request->second.is_finished()) continue;
      if (oldest == requests_.end() || request->second.heard < oldest->second.heard) {
        oldest = request;
      }
    }
    if (now - oldest->second.heard < kUnheardRequest) break;
    requests_.erase(oldest);
    --known;
  }
}

std::vector<const WatchedRequest*> WatchedFleet::requests(WatchTime now) const {
  std::vector<const WatchedRequest*> out;
  for (const auto& [id, request] : requests_) out.push_back(&request);
  const auto place = [now](const WatchedRequest* request) {
    const RequestState& state = request->state;
    const bool is_queued = state.phase == RequestPhase::kQueued;
    // Among those that have ended, the latest end first; among others, who waits for longest.
    const double age = request->is_finished() ? -seconds(request->heard) : -request->elapsed(now);
    return std::tuple(request->is_finished() ? 2
                      : is_queued            ? 1
                                             : 0,
                      is_queued ? state.ahead : 0, age);
  };
  std::ranges::stable_sort(out, [&](const auto* a, const auto* b) { return place(a) < place(b); });
  return out;
}

std::vector<const WatchedWorker*> WatchedFleet::workers() const {
  std::vector<const WatchedWorker*> out;
  for (const auto& [id, worker] : workers_) out.push_back(&worker);
  const auto place = [](const WatchedWorker* worker) {
    const WorkerStatus& status = worker->status;
    return std::tuple(status.standing == kLost, std::string_view(status.host), status.process);
  };
  std::ranges::stable_sort(out, [&](const auto* a, const auto* b) { return place(a) < place(b); });
  return out;
}

bool WatchedFleet::is_complete() const {
  if (!service_) return false;
  const auto welcome = std::ranges::count_if(
      workers_, [](const auto& entry) { return entry.second.status.standing == "welcome"; });
  return static_cast<std::size_t>(welcome) >= service_->status.workers &&
         unfinished() >= unfinished_said();
}

std::size_t WatchedFleet::unfinished() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      requests_, [](const auto& entry) { return !entry.second.is_finished(); }));
}

std::size_t WatchedFleet::unfinished_said() const {
  return std::size_t{service_->status.queued} + service_->status.planning;
}

void WatchedFleet::keep_requests_few() {
  while (requests_.size() > kRequests || requests_.size() - unfinished() > kFinished) {
    const auto order = [](const auto& entry) {
      return std::tuple(!entry.second.is_finished(), entry.second.heard);
    };
    requests_.erase(std::ranges::min_element(
        requests_, [&](const auto& a, const auto& b) { return order(a) < order(b); }));
  }
}

}  // namespace accord
