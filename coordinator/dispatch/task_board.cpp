#include "coordinator/dispatch/task_board.h"

#include <algorithm>
#include <utility>

#include "common/transport/message_limits.h"
#include "common/transport/scene_pieces.h"

namespace accord {
namespace {

// How much of the past the measured speed remembers.
constexpr double kMemory = 0.9;
// A worker that refuses a task, or fails of it, is not asked again; so many are asked.
constexpr std::size_t kRefusals = 3;

}  // namespace

void TaskBoard::add(RequestWork work, std::vector<NewTask> tasks) {
  const RequestId id = work.request;
  std::erase(idle_scenes_, work.scene);
  requests_[id].work = std::move(work);
  add(id, std::move(tasks));
}

void TaskBoard::add(RequestId request, std::vector<NewTask> tasks) {
  for (NewTask& fresh : tasks) {
    Task& task = tasks_[fresh.id];
    task.request = request;
    task.hierarchy = std::move(fresh.hierarchy);
    task.subproblem = std::move(fresh.subproblem);
    task.weight = fresh.weight;
    task.is_ahead = fresh.is_ahead;
    task.places = std::move(fresh.places);
    requests_.at(request).waiting.insert(fresh.id);
  }
  unfinished_ += tasks.size();
  counters_.added += tasks.size();
  may_assign_ = true;
}

void TaskBoard::end(RequestId request) {
  const auto found = requests_.find(request);
  if (found == requests_.end()) return;
  const SceneHash scene = found->second.work.scene;
  std::vector<TaskId> tasks;
  for (const auto& [id, task] : tasks_) {
    if (task.request == request) tasks.push_back(id);
  }
  cancel(tasks);
  for (const TaskId id : tasks) tasks_.erase(id);  // those that were taken
  requests_.erase(found);
  const bool is_needed = std::ranges::any_of(
      requests_, [&](const auto& entry) { return entry.second.work.scene == scene; });
  if (is_needed) return;
  idle_scenes_.push_back(scene);
  if (idle_scenes_.size() <= settings_.idle_scenes) return;
  forget(idle_scenes_.front());
  idle_scenes_.pop_front();
}

void TaskBoard::forget(const SceneHash& scene) {
  warm_.forget(scene);
  for (auto& [id, worker] : workers_) {
    if (worker.delivery && worker.delivery->scene == scene) worker.delivery.reset();
    if (worker.scenes.erase(scene) == 0) continue;
    Command forget;
    forget.kind = Command::Kind::kForget;
    forget.scene = scene;
    worker.outbox.emplace_back(std::move(forget));
  }
}

void TaskBoard::cancel(const std::vector<TaskId>& tasks) {
  std::set<TaskId> dropped;
  for (const TaskId id : tasks) {
    const auto found = tasks_.find(id);
    if (found == tasks_.end()) continue;
    if (requests_.at(found->second.request).waiting.erase(id) > 0) {
      --unfinished_;
      ++counters_.cancelled;
      tasks_.erase(found);
    } else if (drop_finished(id)) {
      tasks_.erase(found);
    } else {
      dropped.insert(id);
    }
  }
  for (auto& [id, worker] : workers_) {
    Command revoke;
    revoke.kind = Command::Kind::kRevoke;
    for (const TaskId task : dropped) {
      if (worker.tasks.contains(task)) revoke.tasks.push_back({task, tasks_.at(task).epoch});
    }
    if (revoke.tasks.empty()) continue;
    for (const TaskKey& key : revoke.tasks) {
      worker.revoked.add(key);
      drop_from(worker, key.task);
      tasks_.erase(key.task);
    }
    unfinished_ -= revoke.tasks.size();
    counters_.cancelled += revoke.tasks.size();
    worker.outbox.emplace_back(std::move(revoke));
  }
  may_assign_ = true;
}

bool TaskBoard::drop_finished(TaskId id) {
  return std::erase_if(finished_, [id](const FinishedTask& task) { return task.task == id; }) > 0;
}

void TaskBoard::hurry(const std::vector<TaskId>& tasks) {
  for (const TaskId id : tasks) {
    const auto found = tasks_.find(id);
    if (found == tasks_.end()) continue;
    found->second.is_ahead = false;
    for (auto& [worker, record] : workers_) record.ahead.erase(id);
  }
  may_assign_ = true;
}

std::size_t TaskBoard::threads() const {
  std::size_t threads = 0;
  for (const auto& [id, worker] : workers_) {
    if (worker.standing == WorkerRecord::Standing::kWelcome) threads += worker.info.threads;
  }
  return threads;
}

std::optional<FinishedTask> TaskBoard::take_finished() {
  if (finished_.empty()) return std::nullopt;
  FinishedTask task = std::move(finished_.front());
  finished_.pop_front();
  if (task.how != FinishedTask::How::kDone) tasks_.erase(task.task);
  return task;
}

void TaskBoard::accept(TaskId task) {
  tasks_.erase(task);
}

void TaskBoard::finish(TaskId id, FinishedTask::How how, Bytes resolution, EndpointId worker,
                       std::string text) {
  const Task& task = tasks_.at(id);
  requests_.at(task.request).waiting.erase(id);
  finished_.push_back({task.request, id, how, std::move(resolution), 0, worker, std::move(text)});
  --unfinished_;
  switch (how) {
    case FinishedTask::How::kDone:
      ++counters_.done;
      return;
    case FinishedTask::How::kQuarantined:
      ++counters_.quarantined;
      return;
    case FinishedTask::How::kRefused:
      ++counters_.refused;
      return;
  }
}

void TaskBoard::drop_from(WorkerRecord& worker, TaskId id) {
  worker.load -= tasks_.at(id).load;
  worker.tasks.erase(id);
  worker.begun.erase(id);
  worker.ahead.erase(id);
  worker.unheard.erase(id);
  if (!worker.tasks.empty()) return;
  worker.load = 0;  // no rounding adds up
  worker.is_alone_with_suspect = false;
}

void TaskBoard::on_event(const BusEvent& event, Time now) {
  if (const auto* message = std::get_if<Message>(&event.what)) {
    if (const auto* announcement = std::get_if<Announcement>(message)) {
      on_announcement(event.peer, *announcement, now);
      return;
    }
    const auto found = workers_.find(event.peer);
    if (found == workers_.end()) {  // has not announced itself, or was given up
      const auto* results = std::get_if<ResultBatch>(message);
      if (results != nullptr) counters_.late += results->results.size();
      return;
    }
    WorkerRecord& worker = found->second;
    worker.heard = now;
    if (const auto* results = std::get_if<ResultBatch>(message)) {
      for (const ResultItem& item : results->results) on_result(event.peer, worker, item);
    } else if (const auto* heartbeat = std::get_if<Heartbeat>(message)) {
      on_heartbeat(worker, *heartbeat, now);
    } else if (const auto* request = std::get_if<SceneRequest>(message)) {
      on_scene_request(worker, *request);
    }
    return;
  }
  if (std::holds_alternative<PeerLost>(event.what)) {
    give_up(event.peer, GivenUp::kGone, "was lost");
  }
  const auto found = workers_.find(event.peer);
  if (found != workers_.end()) found->second.blocked_until = now;  // it can be reached
}

void TaskBoard::on_result(EndpointId sender, WorkerRecord& worker, const ResultItem& item) {
  const TaskId id = item.key.task;
  if (!worker.tasks.contains(id) || tasks_.at(id).epoch != item.key.epoch) {
    count_dropped(worker, item.key);
    return;
  }
  drop_from(worker, id);
  worker.answered.add(item.key);
  may_assign_ = true;
  Task& task = tasks_.at(id);
  switch (item.outcome) {
    case ResultItem::Outcome::kDone:
      if (item.seconds > 0) {
        seconds_per_weight_ =
            kMemory * seconds_per_weight_ + (1 - kMemory) * item.seconds / task.weight;
        counters_.solving_seconds += item.seconds;
      }
      finish(id, FinishedTask::How::kDone, item.resolution, sender, "");
      finished_.back().seconds = item.seconds;
      return;
    case ResultItem::Outcome::kHandedBack:
      take_back(id, Reassigned::kHandedBack, false, "it was handed back: " + item.text);
      return;
    case ResultItem::Outcome::kRefused:
      task.refused_by.insert(sender);
      task.last_trouble = item.text;
      if (task.refused_by.size() >= kRefusals) {
        finish(id, FinishedTask::How::kRefused, {}, sender, item.text);
      } else {
        take_back(id, Reassigned::kRefused, false, item.text);
      }
      return;
    case ResultItem::Outcome::kFailed:
      task.refused_by.insert(sender);
      take_back(id, Reassigned::kFailed, true, "a worker failed: " + item.text);
      return;
  }
}

// A result that no task of this worker waits for.
void TaskBoard::count_dropped(const WorkerRecord& worker, const TaskKey& key) {
  if (worker.answered.has(key)) {
    ++counters_.duplicate;
  } else if (worker.revoked.has(key)) {
    ++counters_.moot;
  } else {
    ++counters_.late;
  }
}

void TaskBoard::take_back(TaskId id, Reassigned reason, bool is_to_blame, const std::string& why) {
  Task& task = tasks_.at(id);
  ++task.epoch;
  task.sent.reset();
  task.waits_since.reset();
  may_assign_ = true;
  if (is_to_blame) {
    ++task.deaths;
    task.last_trouble = why;
  }
  if (task.deaths >= (task.is_ahead ? 1 : settings_.deaths)) {
    finish(id, FinishedTask::How::kQuarantined, {}, {}, task.last_trouble);
    return;
  }
  ++counters_.reassigned_since(reason);
  requests_.at(task.request).waiting.insert(id);
}

void TaskBoard::reject(const FinishedTask& finished, const std::string& why) {
  const auto found = workers_.find(finished.worker);
  if (found != workers_.end()) {
    if (found->second.standing != WorkerRecord::Standing::kDistrusted) {
      ++counters_.workers_distrusted;
    }
    found->second.standing = WorkerRecord::Standing::kDistrusted;
    found->second.why = why;
    Command refuse;
    refuse.kind = Command::Kind::kRefuse;
    refuse.text = why.substr(0, kTextBytes);
    found->second.outbox.emplace_back(std::move(refuse));
  }
  give_up(finished.worker, GivenUp::kDistrusted, why);
  if (!tasks_.contains(finished.task)) return;  // the request has ended
  ++unfinished_;
  tasks_.at(finished.task).refused_by.insert(finished.worker);
  take_back(finished.task, Reassigned::kDistrusted, false, why);
}

TaskBoard::Load TaskBoard::load(Time now) const {
  Load load;
  for (const auto& [id, request] : requests_) {
    load.waiting += request.waiting.size();
    for (const TaskId waiting : request.waiting) {
      const Task& task = tasks_.at(waiting);
      if (task.waits_since && !task.is_ahead) {
        load.oldest = std::max(load.oldest, now - *task.waits_since);
      }
    }
  }
  load.assigned = unfinished_ - load.waiting;
  for (const auto& [id, worker] : workers_) {
    ++load.workers[worker.standing];
    if (worker.standing != WorkerRecord::Standing::kWelcome) continue;
    load.threads += worker.info.threads;
    if (worker.beat) load.busy += worker.info.threads - worker.idle_threads;
  }
  return load;
}
}  // namespace accord
