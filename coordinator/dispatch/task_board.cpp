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

double seconds(TaskBoard::Time time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

void TaskBoard::add(RequestWork work, std::vector<NewTask> tasks) {
  const RequestId id = work.request;
  requests_[id].work = std::move(work);
  add(id, std::move(tasks));
}

void TaskBoard::add(RequestId request, std::vector<NewTask> tasks) {
  for (NewTask& fresh : tasks) {
    Task& task = tasks_[fresh.id];
    task.request = request;
    task.subproblem = std::move(fresh.subproblem);
    task.weight = fresh.weight;
    requests_.at(request).waiting.insert(fresh.id);
  }
  unfinished_ += tasks.size();
  may_assign_ = true;
}

void TaskBoard::end(RequestId request) {
  const auto found = requests_.find(request);
  if (found == requests_.end()) return;
  const SceneHash scene = found->second.work.scene;
  unfinished_ -= found->second.waiting.size();
  for (auto& [id, worker] : workers_) {
    Command revoke;
    revoke.kind = Command::Kind::kRevoke;
    for (const TaskId task : worker.tasks) {
      if (tasks_.at(task).request == request) revoke.tasks.push_back({task, tasks_.at(task).epoch});
    }
    for (const TaskKey& key : revoke.tasks) drop_from(worker, key.task);
    unfinished_ -= revoke.tasks.size();
    if (!revoke.tasks.empty()) worker.outbox.emplace_back(std::move(revoke));
  }
  std::erase_if(tasks_, [&](const auto& entry) { return entry.second.request == request; });
  std::erase_if(finished_, [&](const FinishedTask& task) { return task.request == request; });
  requests_.erase(found);
  may_assign_ = true;
  const bool is_needed = std::ranges::any_of(
      requests_, [&](const auto& entry) { return entry.second.work.scene == scene; });
  if (is_needed) return;
  for (auto& [id, worker] : workers_) {
    if (worker.delivery && worker.delivery->scene == scene) worker.delivery.reset();
    if (worker.scenes.erase(scene) == 0) continue;
    Command forget;
    forget.kind = Command::Kind::kForget;
    forget.scene = scene;
    worker.outbox.emplace_back(std::move(forget));
  }
}

std::optional<FinishedTask> TaskBoard::take_finished() {
  if (taken_) tasks_.erase(*taken_);
  taken_.reset();
  if (finished_.empty()) return std::nullopt;
  FinishedTask task = std::move(finished_.front());
  finished_.pop_front();
  taken_ = task.task;
  return task;
}

void TaskBoard::finish(TaskId id, FinishedTask::How how, Bytes resolution, EndpointId worker,
                       std::string text) {
  const Task& task = tasks_.at(id);
  requests_.at(task.request).waiting.erase(id);
  finished_.push_back({task.request, id, how, std::move(resolution), worker, std::move(text)});
  --unfinished_;
  ++counters_.finished;
  if (how == FinishedTask::How::kQuarantined) ++counters_.quarantined;
}

void TaskBoard::drop_from(WorkerRecord& worker, TaskId id) {
  worker.load -= tasks_.at(id).load;
  worker.tasks.erase(id);
  worker.begun.erase(id);
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
    if (found == workers_.end()) return;  // has not announced itself, or was given up
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
  if (std::holds_alternative<PeerLost>(event.what)) give_up(event.peer, "was lost", true);
  const auto found = workers_.find(event.peer);
  if (found != workers_.end()) found->second.blocked_until = now;  // it can be reached
}

void TaskBoard::on_announcement(EndpointId id, const Announcement& announcement, Time now) {
  const auto [found, is_new] = workers_.try_emplace(id);
  WorkerRecord& worker = found->second;
  worker.info = announcement;
  worker.heard = now;
  if (announcement.leaving && worker.standing == WorkerRecord::Standing::kWelcome) {
    worker.standing = WorkerRecord::Standing::kLeaving;
    worker.why = "it is leaving";
  }
  Command answer;
  if (announcement.protocol != kProtocol) {
    if (worker.standing != WorkerRecord::Standing::kRefused) ++counters_.workers_refused;
    worker.standing = WorkerRecord::Standing::kRefused;
    worker.why = "it speaks protocol " + std::to_string(announcement.protocol) +
                 "; this coordinator speaks " + std::to_string(kProtocol);
  } else if (announcement.threads == 0) {
    worker.standing = WorkerRecord::Standing::kRefused;
    worker.why = "it has no threads to work with";
  }
  const bool is_refused = worker.standing == WorkerRecord::Standing::kRefused ||
                          worker.standing == WorkerRecord::Standing::kDistrusted;
  answer.kind = is_refused ? Command::Kind::kRefuse : Command::Kind::kWelcome;
  if (is_refused) answer.text = worker.why;
  worker.outbox.emplace_back(std::move(answer));
  worker.greeted = now;
  may_assign_ = true;
}

void TaskBoard::on_result(EndpointId sender, WorkerRecord& worker, const ResultItem& item) {
  const TaskId id = item.key.task;
  if (!worker.tasks.contains(id) || tasks_.at(id).epoch != item.key.epoch) {
    ++counters_.late;
    return;
  }
  drop_from(worker, id);
  may_assign_ = true;
  Task& task = tasks_.at(id);
  switch (item.outcome) {
    case ResultItem::Outcome::kDone:
      if (item.seconds > 0) {
        seconds_per_weight_ =
            kMemory * seconds_per_weight_ + (1 - kMemory) * item.seconds / task.weight;
      }
      finish(id, FinishedTask::How::kDone, item.resolution, sender, "");
      return;
    case ResultItem::Outcome::kHandedBack:
      take_back(id, false, "it was handed back: " + item.text);
      return;
    case ResultItem::Outcome::kRefused:
      task.refused_by.insert(sender);
      task.last_trouble = item.text;
      if (task.refused_by.size() >= kRefusals) {
        finish(id, FinishedTask::How::kRefused, {}, sender, item.text);
      } else {
        take_back(id, false, item.text);
      }
      return;
    case ResultItem::Outcome::kFailed:
      task.refused_by.insert(sender);
      take_back(id, true, "a worker failed: " + item.text);
      return;
  }
}

void TaskBoard::take_back(TaskId id, bool is_to_blame, const std::string& why) {
  Task& task = tasks_.at(id);
  ++task.epoch;
  task.sent.reset();
  may_assign_ = true;
  if (is_to_blame) {
    ++task.deaths;
    task.last_trouble = why;
  }
  if (task.deaths >= settings_.deaths) {
    finish(id, FinishedTask::How::kQuarantined, {}, {}, task.last_trouble);
    return;
  }
  ++counters_.reassigned;
  requests_.at(task.request).waiting.insert(id);
}

void TaskBoard::reject(const FinishedTask& finished, const std::string& why) {
  const auto found = workers_.find(finished.worker);
  if (found != workers_.end()) {
    found->second.standing = WorkerRecord::Standing::kDistrusted;
    found->second.why = why;
    Command refuse;
    refuse.kind = Command::Kind::kRefuse;
    refuse.text = why.substr(0, kTextBytes);
    found->second.outbox.emplace_back(std::move(refuse));
  }
  give_up(finished.worker, why, false);
  if (!tasks_.contains(finished.task)) return;  // the request has ended
  taken_.reset();
  ++unfinished_;
  tasks_.at(finished.task).refused_by.insert(finished.worker);
  take_back(finished.task, false, why);
}

// A worker names all that it has in hand. What it has been sent, and does not name time and again,
// has not reached it, or its result has not come back.
void TaskBoard::on_heartbeat(WorkerRecord& worker, const Heartbeat& heartbeat, Time now) {
  constexpr unsigned kUnheard = 3;
  std::set<TaskId> named;
  for (const TaskProgress& progress : heartbeat.tasks) {
    const TaskId id = progress.key.task;
    if (!worker.tasks.contains(id) || tasks_.at(id).epoch != progress.key.epoch) continue;
    named.insert(id);
    if (progress.begun) worker.begun.insert(id);
  }
  std::vector<TaskId> lost;
  for (const TaskId id : worker.tasks) {
    const Task& task = tasks_.at(id);
    if (named.contains(id) || !task.sent || now - *task.sent < settings_.heartbeat) {
      worker.unheard.erase(id);
    } else if (++worker.unheard[id] >= kUnheard) {
      lost.push_back(id);
    }
  }
  for (const TaskId id : lost) {
    drop_from(worker, id);
    take_back(id, false, "it got lost on its way");
  }
}

void TaskBoard::on_scene_request(WorkerRecord& worker, const SceneRequest& request) {
  for (const auto& [id, entry] : requests_) {
    if (entry.work.scene != request.scene || !entry.work.scene_bytes) continue;
    if (request.offset > entry.work.scene_bytes->size()) return;
    worker.scenes.insert(request.scene);
    worker.delivery = SceneDelivery{request.scene, entry.work.scene_bytes, request.offset};
    return;
  }
}

// Its tasks are others' now. Of those it may have died of, the ones that it had begun.
void TaskBoard::give_up(EndpointId id, const std::string& why, bool is_lost) {
  const auto found = workers_.find(id);
  if (found == workers_.end()) return;
  WorkerRecord& worker = found->second;
  std::set<TaskId> begun = std::exchange(worker.begun, {});
  const std::set<TaskId> tasks = std::exchange(worker.tasks, {});
  worker.unheard.clear();
  // It begins in order; what it has not said yet may have been its last.
  std::size_t threads = worker.info.threads;
  for (auto task = tasks.begin(); task != tasks.end() && begun.size() < threads; ++task) {
    begun.insert(*task);
  }
  worker.load = 0;
  worker.is_alone_with_suspect = false;
  const std::string trouble = "worker " + to_string(id) +
                              (worker.info.host.empty() ? "" : " on " + worker.info.host) + " " +
                              why;
  for (const TaskId task : tasks) {
    if (is_lost && begun.contains(task)) {
      blame(task, begun.size() == 1, trouble);
    } else {
      take_back(task, false, trouble);
    }
  }
  if (!is_lost) return;
  ++counters_.workers_lost;
  workers_.erase(found);
}

void TaskBoard::blame(TaskId id, bool was_alone, const std::string& why) {
  tasks_.at(id).is_suspect = true;
  take_back(id, was_alone, why);
}

void TaskBoard::on_time(Time now) {
  std::vector<EndpointId> silent;
  for (auto& [id, worker] : workers_) {
    if (now - worker.heard >= settings_.lease) silent.push_back(id);
    if (worker.standing == WorkerRecord::Standing::kWelcome &&
        now - worker.greeted >= settings_.heartbeat) {
      worker.outbox.emplace_back(Command{});  // alive
      worker.greeted = now;
    }
  }
  for (const EndpointId id : silent) give_up(id, "was silent for too long", true);
}

std::optional<TaskBoard::Time> TaskBoard::next_deadline() const {
  std::optional<Time> next;
  const auto consider = [&](Time time) { next = next ? std::min(*next, time) : time; };
  for (const auto& [id, worker] : workers_) {
    consider(worker.heard + settings_.lease);
    if (worker.standing == WorkerRecord::Standing::kWelcome) {
      consider(worker.greeted + settings_.heartbeat);
    }
    if (!worker.outbox.empty() || worker.delivery) consider(worker.blocked_until);
  }
  return next;
}

// Each thread of a worker has work in hand and as much again waiting, so that it does not idle
// while a result travels.
bool TaskBoard::has_room(const WorkerRecord& worker) const {
  if (worker.standing != WorkerRecord::Standing::kWelcome) return false;
  if (worker.is_alone_with_suspect) return false;
  const auto threads = static_cast<double>(worker.info.threads);
  return worker.tasks.size() < worker.info.threads ||
         worker.load < 2 * threads * seconds(settings_.batch);
}

bool TaskBoard::nobody_takes(const Task& task) const {
  bool has_workers = false;
  for (const auto& [id, worker] : workers_) {
    if (worker.standing != WorkerRecord::Standing::kWelcome) continue;
    has_workers = true;
    if (!task.refused_by.contains(id) && task.subproblem.size() <= worker.info.task_bytes) {
      return false;
    }
  }
  return has_workers;
}

TaskBoard::Worker TaskBoard::least_loaded(const Task& task) {
  Worker best = workers_.end();
  const auto load = [](const WorkerRecord& worker) {
    const auto threads = static_cast<double>(worker.info.threads);
    return std::pair(worker.load / threads, static_cast<double>(worker.tasks.size()) / threads);
  };
  for (auto worker = workers_.begin(); worker != workers_.end(); ++worker) {
    if (!has_room(worker->second) || task.refused_by.contains(worker->first)) continue;
    if (task.subproblem.size() > worker->second.info.task_bytes) continue;
    if (task.is_suspect && !worker->second.tasks.empty()) continue;
    if (best == workers_.end() || load(worker->second) < load(best->second)) best = worker;
  }
  return best;
}

// Of so many tasks what one thread may be given at once: nobody's batch takes what others would
// idle for.
std::size_t TaskBoard::fair_share(std::size_t waiting) const {
  std::size_t threads = 0;
  for (const auto& [id, worker] : workers_) {
    if (worker.standing == WorkerRecord::Standing::kWelcome) threads += worker.info.threads;
  }
  return std::clamp<std::size_t>(waiting / std::max<std::size_t>(1, threads), 1, kBatchItems);
}

void TaskBoard::assign() {
  if (!may_assign_) return;
  may_assign_ = false;
  for (auto& [id, request] : requests_) assign(id, request);
}

// Suspects go first, then long tasks, short ones in batches.
void TaskBoard::assign(RequestId request_id, Request& request) {
  std::vector<TaskId> waiting(request.waiting.begin(), request.waiting.end());
  std::ranges::stable_sort(waiting, std::greater{}, [&](TaskId id) {
    return std::pair(tasks_.at(id).is_suspect, tasks_.at(id).weight);
  });
  for (std::size_t next = 0; next < waiting.size();) {
    const Task& first = tasks_.at(waiting[next]);
    const Worker worker = least_loaded(first);
    if (worker == workers_.end()) {
      if (nobody_takes(first)) {
        const std::string why =
            first.last_trouble.empty() ? "it is larger than any worker takes" : first.last_trouble;
        finish(waiting[next], FinishedTask::How::kRefused, {}, {}, why);
      }
      ++next;
      continue;
    }
    WorkerRecord& record = worker->second;
    const std::size_t share = fair_share(waiting.size() - next);
    TaskBatch batch{request_id, request.work.scene, request.work.hierarchy, {}};
    double load = 0;
    std::size_t bytes = 0;
    for (; next < waiting.size() && batch.tasks.size() < share; ++next) {
      Task& task = tasks_.at(waiting[next]);
      const double expected = task.weight * seconds_per_weight_;
      const bool fits = load + expected <= seconds(settings_.batch) &&
                        bytes + task.subproblem.size() <= kBatchBytes &&
                        task.subproblem.size() <= record.info.task_bytes &&
                        !task.refused_by.contains(worker->first) && !task.is_suspect;
      if (!batch.tasks.empty() && !fits) break;
      task.load = expected;
      load += expected;
      bytes += task.subproblem.size();
      record.load += expected;
      record.tasks.insert(waiting[next]);
      request.waiting.erase(waiting[next]);
      batch.tasks.push_back({{waiting[next], task.epoch}, task.subproblem});
      ++counters_.assigned;
      if (!task.is_suspect) continue;
      record.is_alone_with_suspect = true;
      ++next;
      break;
    }
    record.outbox.emplace_back(std::move(batch));
  }
}

std::optional<TaskBoard::Outgoing> TaskBoard::next_outgoing(Time now) {
  assign();
  if (workers_.empty()) return std::nullopt;
  // In turn, so that nobody's scene keeps others from their tasks.
  auto worker = last_sender_ ? workers_.upper_bound(*last_sender_) : workers_.begin();
  for (std::size_t i = 0; i < workers_.size(); ++i, ++worker) {
    if (worker == workers_.end()) worker = workers_.begin();
    WorkerRecord& record = worker->second;
    if (record.blocked_until > now) continue;
    if (record.outbox.empty() && record.delivery) {
      SceneDelivery& delivery = *record.delivery;
      if (delivery.offset < delivery.bytes->size()) {
        record.outbox.emplace_back(piece_of(*delivery.bytes, delivery.scene, delivery.offset));
      } else {
        record.delivery.reset();
      }
    }
    if (record.outbox.empty()) continue;
    last_sender_ = worker->first;
    return Outgoing{worker->first, record.outbox.front()};
  }
  return std::nullopt;
}

void TaskBoard::on_published(EndpointId to, Published outcome, Time now) {
  const auto found = workers_.find(to);
  if (found == workers_.end()) return;
  WorkerRecord& worker = found->second;
  switch (outcome) {
    case Published::kSent:
      if (const auto* piece = std::get_if<ScenePiece>(&worker.outbox.front())) {
        if (worker.delivery) worker.delivery->offset = piece->offset + piece->data.size();
      }
      if (const auto* batch = std::get_if<TaskBatch>(&worker.outbox.front())) {
        for (const TaskItem& item : batch->tasks) {
          if (worker.tasks.contains(item.key.task)) tasks_.at(item.key.task).sent = now;
        }
      }
      worker.outbox.pop_front();
      return;
    case Published::kFull:
      worker.blocked_until = now + settings_.retry;
      return;
    case Published::kInvalid:
      // A task beyond a limit of messages: nobody can be given it.
      if (const auto* batch = std::get_if<TaskBatch>(&worker.outbox.front())) {
        for (const TaskItem& item : batch->tasks) {
          if (!worker.tasks.contains(item.key.task)) continue;
          drop_from(worker, item.key.task);
          finish(item.key.task, FinishedTask::How::kRefused, {}, {},
                 "the subproblem is too large to be sent");
        }
      }
      worker.outbox.pop_front();
      return;
    case Published::kNoPeer:
      // It says goodbye on its own time; until then nothing is lost by waiting.
      worker.blocked_until = now + settings_.heartbeat;
      return;
    case Published::kClosed:
      return;
  }
}

}  // namespace accord
