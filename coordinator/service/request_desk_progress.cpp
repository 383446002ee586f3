// A request's way from the queue to its plan.
#include <algorithm>
#include <utility>

#include "common/io/plan_file.h"
#include "coordinator/service/request_desk.h"

namespace accord {
namespace {

constexpr auto kForgetEvery = std::chrono::seconds(1);

RequestPhase phase_of(Progress::Phase phase) {
  switch (phase) {
    case Progress::Phase::kInitialPaths:
      return RequestPhase::kInitialPaths;
    case Progress::Phase::kConflicts:
      return RequestPhase::kConflicts;
    case Progress::Phase::kProof:
      return RequestPhase::kProof;
  }
  return RequestPhase::kConflicts;
}

// Planned anew.
bool would_end_so_again(const Plan& plan) {
  return plan.status != PlanStatus::kCancelled && plan.status != PlanStatus::kTimeout;
}

std::size_t waypoints_of(const Plan& plan) {
  std::size_t waypoints = 0;
  for (const RobotPlan& robot : plan.robots) waypoints += robot.trajectory.size();
  return waypoints;
}

}  // namespace

void RequestDesk::restore(const JournalEntry& entry,
                          tl::expected<RequestRecord, std::string> record, Now now) {
  if (entry.outcome) {
    const double finished = entry.outcome->finished_at;
    kept_[entry.id] = {entry.content, std::max(0.0, finished - entry.accepted_at), finished};
    return;
  }
  ++counters_.restored;
  Request& request = requests_[entry.id];
  request.is_accepted = true;
  request.content = entry.content;
  request.order = next_order_++;
  request.accepted = entry.accepted_at;
  const std::chrono::duration<double> age(std::clamp(now.wall - entry.accepted_at, 0.0, 1e8));
  request.since = now.steady - std::chrono::duration_cast<std::chrono::nanoseconds>(age);
  request.state.id = entry.id;
  if (!record) {
    end(entry.id, request, PlanStatus::kInvalid,
        "what the journal holds of it cannot be read: " + record.error(), now);
    return;
  }
  request.scene = std::move(record->scene);
  set_options(record->request, request);
  enqueue(entry.id, request);
  say_state(entry.id, request, now);  // who watches knows nothing of the life before
}

RequestDesk::Place RequestDesk::place_of(const std::string& id, const Request& request) const {
  return {-std::int64_t{request.priority}, request.order, id};
}

void RequestDesk::enqueue(const std::string& id, Request& request) {
  request.stage = Stage::kQueued;
  queue_.insert(place_of(id, request));
}

void RequestDesk::settle(Now now) {
  if (!to_accept_.empty()) actions_.emplace_back(Accept{std::exchange(to_accept_, {})});
  begin_next(now);
  if (retry_at_ && now.steady >= *retry_at_) {
    retry_at_.reset();
    std::ranges::move(std::exchange(to_finish_again_, {}), std::back_inserter(to_finish_));
  }
  if (!to_finish_.empty()) {
    Finish write;
    for (const std::string& id : to_finish_) {
      const Request& request = requests_.at(id);
      write.requests.push_back({id, request.plan.status, request.json, now.wall});
    }
    to_finish_.clear();
    actions_.emplace_back(std::move(write));
  }
  forget_old(now);
}

void RequestDesk::begin_next(Now now) {
  while (!draining_ && planning_ < settings_.planning && !queue_.empty()) {
    const std::string id = std::get<2>(*queue_.begin());
    queue_.erase(queue_.begin());
    Request& request = requests_.at(id);
    if (request.deadline > 0) {
      const double left = request.deadline - (now.wall - request.accepted);
      if (left <= 0) {
        end(id, request, PlanStatus::kTimeout, "the deadline passed before its planning was begun",
            now);
        continue;
      }
      request.options.timeout = left;
    }
    request.stage = Stage::kPlanning;
    request.begun = now.steady;
    counters_.queued.add(std::chrono::duration<double>(now.steady - request.since).count());
    ++planning_;
    actions_.emplace_back(Begin{id, request.scene, request.options, request.content});
  }
}

void RequestDesk::on_progress(const std::string& id, const Progress& progress, Now now) {
  const auto found = requests_.find(id);
  if (found == requests_.end() || found->second.stage != Stage::kPlanning) return;
  RequestState& state = found->second.state;
  const RequestState before = state;
  state.phase = phase_of(progress.phase);
  state.robots_planned = static_cast<std::uint32_t>(progress.robots_planned);
  state.conflicts_found = std::max<std::uint64_t>(state.conflicts_found, progress.conflicts_found);
  state.conflicts_resolved =
      std::max<std::uint64_t>(state.conflicts_resolved, progress.conflicts_resolved);
  state.rounds = std::max<std::uint64_t>(state.rounds, progress.rounds);
  state.per_cent = std::max(state.per_cent, per_cent(progress, state.robots));
  state.best_cost = progress.sum_of_costs;
  count_progress(before, state);
  if (found->second.is_accepted) say_state(id, found->second, now);
}

void RequestDesk::say_state(const std::string& id, Request& request, Now now) {
  RequestState& state = request.state;
  if (!request.is_told) {
    state.elapsed = std::chrono::duration<double>(now.steady - request.since).count();
  }
  state.ahead = 0;
  if (request.stage == Stage::kQueued) {
    const auto place = queue_.find(place_of(id, request));
    state.ahead = static_cast<std::uint32_t>(std::distance(queue_.begin(), place));
  }
  publish(state);
}

void RequestDesk::on_planned(const std::string& id, Plan plan, std::string json, Now now) {
  const auto found = requests_.find(id);
  if (found == requests_.end() || found->second.stage != Stage::kPlanning) return;
  --planning_;
  Request& request = found->second;
  if (request.is_refused) {
    drop(found);
    return;
  }
  if (draining_ && settings_.outlives && !request.is_cancelled &&
      plan.status == PlanStatus::kCancelled) {
    enqueue(id, request);  // for the next coordinator; who asks meanwhile is told so
    return;
  }
  count_planned(plan, request, now);
  if (const std::size_t waypoints = waypoints_of(plan); waypoints > settings_.waypoints) {
    end(id, request, PlanStatus::kInvalid,
        "the plan has " + std::to_string(waypoints) + " waypoints; no more than " +
            std::to_string(settings_.waypoints) + " are handed out",
        now);
    return;
  }
  request.plan = std::move(plan);
  request.json = std::move(json);
  finish(id, request, now);
}

// A request that ends without having been planned.
void RequestDesk::end(const std::string& id, Request& request, PlanStatus status,
                      std::string message, Now now) {
  request.plan = unsolved_plan(request.scene.get(), request.options, status, std::move(message));
  request.json = to_json(request.plan);
  finish(id, request, now);
}

// A plan is handed out before it is in the journal: whoever waits need not wait for the disk, and
// after a crash in between a restart makes it anew, the same. An end that would not come again is
// written first, lest a request that was said to be cancelled be planned after all.
void RequestDesk::finish(const std::string& id, Request& request, Now now) {
  request.stage = Stage::kFinished;
  if (!request.is_accepted) return;  // once it is
  ++counters_.finished[request.plan.status];
  if (would_end_so_again(request.plan)) tell(id, request, now);
  to_finish_.push_back(id);
}

void RequestDesk::tell(const std::string& id, Request& request, Now now) {
  note_end(request.plan, request.state);
  say_state(id, request, now);
  request.is_told = true;
  publish(FinishedPlan{id, request.plan, request.scene, to_string(request.content)});
}

// Where the journal cannot be written, plans stay here, for whoever asks.
void RequestDesk::on_stored(const std::vector<std::string>& ids, const std::string& fault,
                            Now now) {
  count_write(fault);
  for (const std::string& id : ids) {
    const auto found = requests_.find(id);
    if (found == requests_.end()) continue;
    if (!found->second.is_told) tell(id, found->second, now);
    if (!fault.empty() && !draining_) {
      to_finish_again_.push_back(id);
      retry_at_ = now.steady + settings_.retry;
      continue;
    }
    if (!fault.empty()) {
      enqueue(id, found->second);  // for the next coordinator, which plans it anew
      continue;
    }
    kept_[id] = {found->second.content, found->second.state.elapsed, now.wall};
    drop(found);
  }
}

void RequestDesk::forget_old(Now now) {
  if (forget_at_ && now.steady < *forget_at_) return;
  forget_at_ = now.steady + kForgetEvery;
  const double before = now.wall - settings_.keep;
  const auto forgotten =
      std::erase_if(kept_, [&](const auto& entry) { return entry.second.finished < before; });
  if (forgotten == 0 && !is_forgetting_) return;
  is_forgetting_ = false;
  actions_.emplace_back(Forget{before});
}

std::optional<std::chrono::nanoseconds> RequestDesk::next_deadline() const {
  if (retry_at_ && forget_at_) return std::min(*retry_at_, *forget_at_);
  return retry_at_ ? retry_at_ : forget_at_;
}

void RequestDesk::drain(Now now) {
  if (draining_) return;
  draining_ = true;
  if (retry_at_) retry_at_ = now.steady;  // a last time
  for (const auto& [id, request] : requests_) {
    if (request.stage == Stage::kPlanning) actions_.emplace_back(Stop{id});
  }
  if (settings_.outlives) return;
  for (const Place& place : std::exchange(queue_, {})) {
    const std::string& id = std::get<2>(place);
    end(id, requests_.at(id), PlanStatus::kCancelled, "cancelled: the service is about to end",
        now);
  }
}

bool RequestDesk::is_done() const {
  return draining_ && std::ranges::none_of(requests_, [&](const auto& entry) {
           const Request& request = entry.second;
           return request.stage != Stage::kQueued || !request.is_accepted;
         });
}

}  // namespace accord
