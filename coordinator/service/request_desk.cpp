#include "coordinator/service/request_desk.h"

#include <algorithm>
#include <utility>

#include "common/io/request_names.h"
#include "common/io/wire/request_codec.h"

namespace accord {
namespace {

constexpr const char* kIsEnding = "the service is about to end";

// Of what a request brought, while it waits to be read.
std::size_t bytes_of(const PlanRequest& request) {
  std::size_t bytes = request.scene_text.size();
  for (const PlanRequest::Attachment& file : request.attachments) bytes += file.content.size();
  return bytes;
}

}  // namespace

void RequestDesk::on_request(FleetRequest request, Now now) {
  if (auto* plan = std::get_if<PlanRequest>(&request)) {
    submit(std::move(*plan), now);
  } else if (const auto* gone = std::get_if<CancelRequest>(&request)) {
    cancel(gone->id, now);
  } else {
    resend(std::get<ResendRequest>(request).id, now);
  }
}

void RequestDesk::submit(PlanRequest request, Now now) {
  const std::string id = request.id;
  if (!is_request_id(id)) {
    reject(id, Rejection::kBadId, "request_id", "expected " + std::string(kRequestIdInWords));
    return;
  }
  const SceneHash content = request_hash(request);
  const auto known = requests_.find(id);
  const auto kept = kept_.find(id);
  if (known != requests_.end() && known->second.content == content) {
    reply_again(id, known->second, now);
  } else if (kept != kept_.end() && kept->second.content == content) {
    resend(id, now);
  } else if (known != requests_.end() || kept != kept_.end()) {
    reject(id, Rejection::kIdInUse, "request_id",
           "\"" + id + "\" is the id of another request, with other content");
  } else if (const auto why_not = refusal(request, bytes_of(request))) {
    reject(id, why_not->reason, "", why_not->text);
  } else {
    Request& fresh = requests_[id];
    fresh.content = content;
    fresh.bytes = bytes_of(request);
    fresh.order = next_order_++;
    fresh.state.id = id;
    bytes_ += fresh.bytes;
    actions_.emplace_back(Read{std::move(request)});
  }
}

// Why there is no room for one more.
std::optional<RequestReply> RequestDesk::refusal(const PlanRequest& request,
                                                 std::size_t bytes) const {
  const auto because = [&](Rejection reason, std::string text) {
    return RequestReply{request.id, false, reason, "", std::move(text)};
  };
  if (draining_) return because(Rejection::kShuttingDown, kIsEnding);
  if (requests_.size() >= settings_.queued + settings_.planning) {
    return because(Rejection::kQueueFull, "no more than " + std::to_string(settings_.queued) +
                                              " requests are held, and so many are waiting");
  }
  if (bytes_ + bytes > settings_.queued_bytes) {
    return because(Rejection::kQueueFull, "no more than " + std::to_string(settings_.queued_bytes) +
                                              " bytes of requests are held; there are " +
                                              std::to_string(bytes_) + ", and it would bring " +
                                              std::to_string(bytes));
  }
  return std::nullopt;
}

void RequestDesk::reject(const std::string& id, Rejection reason, std::string field,
                         std::string text) {
  ++counters_.rejected[reason];
  publish(RequestReply{id, false, reason, std::move(field), std::move(text)});
}

void RequestDesk::on_read(const PlanRequest& request,
                          tl::expected<ReadyRequest, RequestFault> ready, Now now) {
  const auto found = requests_.find(request.id);
  if (found == requests_.end() || found->second.stage != Stage::kRead) return;
  Request& entry = found->second;
  if (ready && draining_) {
    ready = tl::unexpected(RequestFault{Rejection::kShuttingDown, "", kIsEnding});
  }
  if (!ready) {
    RequestFault& fault = ready.error();
    reject(request.id, fault.reason, std::move(fault.field), std::move(fault.text));
    drop(found);
    return;
  }
  entry.scene = std::move(ready->scene);
  set_options(request, entry);
  entry.accepted = now.wall;
  entry.since = now.steady;
  bytes_ += ready->record.size();
  bytes_ -= std::exchange(entry.bytes, ready->record.size());
  to_accept_.push_back({request.id, entry.content, std::move(ready->record), now.wall});
  enqueue(request.id, entry);
}

void RequestDesk::set_options(const PlanRequest& request, Request& entry) const {
  entry.state.robots = static_cast<std::uint32_t>(entry.scene->robots.size());
  entry.options.method = request.method;
  entry.options.seed = request.seed;
  entry.options.solvers = request.solvers;
  entry.options.threads = settings_.threads;
  entry.deadline = request.deadline;
  entry.priority = request.priority;
}

void RequestDesk::on_accepted(const std::vector<std::string>& ids, const std::string& fault,
                              Now now) {
  count_write(fault);
  for (const std::string& id : ids) {
    const auto found = requests_.find(id);
    if (found == requests_.end()) continue;
    Request& request = found->second;
    if (!fault.empty()) {
      reject(id, Rejection::kNoJournal, "", fault);
      request.is_refused = true;
      if (request.stage == Stage::kPlanning) {
        actions_.emplace_back(Stop{id});
      } else {
        if (request.stage == Stage::kQueued) queue_.erase(place_of(id, request));
        drop(found);
      }
      continue;
    }
    ++counters_.accepted;
    request.is_accepted = true;
    publish(RequestReply{id, true, Rejection::kNone, "", ""});
    if (request.stage == Stage::kFinished) {
      finish(id, request, now);
    } else if (request.is_cancelled) {
      cancel(id, now);
    } else {
      say_state(id, request, now);
    }
  }
}

void RequestDesk::drop(Requests::iterator request) {
  bytes_ -= request->second.bytes;
  requests_.erase(request);
}

void RequestDesk::cancel(const std::string& id, Now now) {
  const auto found = requests_.find(id);
  if (found == requests_.end()) {
    resend(id, now);  // it is finished, or nobody knows it
    return;
  }
  Request& request = found->second;
  request.is_cancelled = true;
  if (!request.is_accepted) return;  // once it is
  if (request.stage == Stage::kQueued) {
    queue_.erase(place_of(id, request));
    end(id, request, PlanStatus::kCancelled, "cancelled before its planning was begun", now);
  } else if (request.stage == Stage::kPlanning) {
    actions_.emplace_back(Stop{id});
  }
}

void RequestDesk::reply_again(const std::string& id, Request& request, Now now) {
  if (!request.is_accepted) return;  // it is still to come
  publish(RequestReply{id, true, Rejection::kNone, "", ""});
  say_state(id, request, now);
  if (request.is_told)
    publish(FinishedPlan{id, request.plan, request.scene, to_string(request.content)});
}

void RequestDesk::resend(const std::string& id, Now now) {
  if (const auto known = requests_.find(id); known != requests_.end()) {
    reply_again(id, known->second, now);
  } else if (kept_.contains(id)) {
    publish(RequestReply{id, true, Rejection::kNone, "", ""});
    actions_.emplace_back(Recall{id});
  } else {
    reject(id, Rejection::kUnknownRequest, "request_id", "there is no request \"" + id + "\"");
  }
}

void RequestDesk::on_recalled(const std::string& id, tl::expected<Plan, std::string> plan) {
  if (!plan) {
    reject(id, Rejection::kNoJournal, "", plan.error());
    return;
  }
  publish(state_after(id, *plan));
  const auto kept = kept_.find(id);
  publish(FinishedPlan{id, std::move(*plan), nullptr,
                       kept == kept_.end() ? "" : to_string(kept->second.content)});
}

// What was said of a request when it was finished, as far as its plan knows.
RequestState RequestDesk::state_after(const std::string& id, const Plan& plan) const {
  RequestState state;
  state.id = id;
  state.robots = state.robots_planned = static_cast<std::uint32_t>(plan.robots.size());
  note_end(plan, state);
  if (const auto kept = kept_.find(id); kept != kept_.end()) state.elapsed = kept->second.elapsed;
  return state;
}

std::optional<RequestDesk::Action> RequestDesk::next_action() {
  if (actions_.empty()) return std::nullopt;
  Action action = std::move(actions_.front());
  actions_.pop_front();
  return action;
}

}  // namespace accord
