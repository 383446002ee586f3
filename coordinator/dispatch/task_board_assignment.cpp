// Who gets what, and what is sent next.
#include <algorithm>
#include <utility>

#include "common/transport/message_limits.h"
#include "common/transport/scene_pieces.h"
#include "coordinator/dispatch/task_board.h"

namespace accord {
namespace {

double seconds(TaskBoard::Time time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

// Each thread of a worker has work in hand and as much again waiting, so that it does not idle
// while a result travels. What is ahead of need is for threads that have none, and is in nobody's
// way.
bool TaskBoard::has_room(const WorkerRecord& worker, const Task& task) const {
  if (worker.standing != WorkerRecord::Standing::kWelcome) return false;
  if (worker.is_alone_with_suspect) return false;
  if (task.is_ahead) return worker.tasks.size() < worker.info.threads;
  const auto threads = static_cast<double>(worker.info.threads);
  return worker.tasks.size() - worker.ahead.size() < worker.info.threads ||
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
    if (!has_room(worker->second, task) || task.refused_by.contains(worker->first)) continue;
    if (task.subproblem.size() > worker->second.info.task_bytes) continue;
    if (task.is_suspect && !worker->second.tasks.empty()) continue;
    if (best == workers_.end() || load(worker->second) < load(best->second)) best = worker;
  }
  return best;
}

// Of so many tasks what one thread may be given at once: nobody's batch takes what others would
// idle for.
std::size_t TaskBoard::fair_share(std::size_t waiting) const {
  return std::clamp<std::size_t>(waiting / std::max<std::size_t>(1, threads()), 1, kBatchItems);
}

void TaskBoard::assign() {
  if (!may_assign_) return;
  may_assign_ = false;
  for (const bool is_ahead : {false, true}) {
    for (auto& [id, request] : requests_) assign(id, request, is_ahead);
  }
}

// Suspects go first, then long tasks, short ones in batches. Those ahead of need in the order in
// which they came, each for itself.
void TaskBoard::assign(RequestId request_id, Request& request, bool is_ahead) {
  std::vector<TaskId> waiting;
  for (const TaskId id : request.waiting) {
    if (tasks_.at(id).is_ahead == is_ahead) waiting.push_back(id);
  }
  if (!is_ahead) {
    std::ranges::stable_sort(waiting, std::greater{}, [&](TaskId id) {
      return std::pair(tasks_.at(id).is_suspect, tasks_.at(id).weight);
    });
  }
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
    const std::size_t share = is_ahead ? 1 : fair_share(waiting.size() - next);
    TaskBatch batch{request_id, request.work.scene, first.hierarchy, {}};
    double load = 0;
    std::size_t bytes = 0;
    for (; next < waiting.size() && batch.tasks.size() < share; ++next) {
      Task& task = tasks_.at(waiting[next]);
      const double expected = task.weight * seconds_per_weight_;
      const bool fits = load + expected <= seconds(settings_.batch) &&
                        bytes + task.subproblem.size() <= kBatchBytes &&
                        task.subproblem.size() <= record.info.task_bytes &&
                        task.hierarchy == batch.hierarchy &&
                        !task.refused_by.contains(worker->first) && !task.is_suspect;
      if (!batch.tasks.empty() && !fits) break;
      task.load = expected;
      load += expected;
      bytes += task.subproblem.size();
      record.load += expected;
      record.tasks.insert(waiting[next]);
      if (is_ahead) record.ahead.insert(waiting[next]);
      request.waiting.erase(waiting[next]);
      batch.tasks.push_back({{waiting[next], task.epoch}, task.subproblem});
      ++counters_.assigned;
      if (!task.is_suspect) continue;
      record.is_alone_with_suspect = true;
      ++next;
      break;
    }
    if (!is_ahead) make_way(record);
    record.outbox.emplace_back(std::move(batch));
  }
}

void TaskBoard::make_way(WorkerRecord& worker) {
  Command revoke;
  revoke.kind = Command::Kind::kRevoke;
  while (worker.tasks.size() > worker.info.threads && !worker.ahead.empty()) {
    const TaskId id = *worker.ahead.rbegin();
    Task& task = tasks_.at(id);
    revoke.tasks.push_back({id, task.epoch});
    drop_from(worker, id);
    ++task.epoch;
    task.sent.reset();
    requests_.at(task.request).waiting.insert(id);
    ++counters_.put_off;
  }
  if (!revoke.tasks.empty()) worker.outbox.emplace_back(std::move(revoke));
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
        if (worker.delivery && worker.delivery->scene == piece->scene) {
          worker.delivery->offset = piece->offset + piece->data.size();
        }
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
