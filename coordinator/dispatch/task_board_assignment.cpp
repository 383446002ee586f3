// Who gets what, and what is sent next.
#include <algorithm>
#include <tuple>
#include <utility>

#include "common/transport/message_limits.h"
#include "common/transport/scene_pieces.h"
#include "coordinator/dispatch/task_board.h"

namespace accord {
namespace {

// Of tasks that wait, a worker gets the one that it is prepared for best among so many, none of
// which is expected to take less than this part of the longest: long ones still go first.
constexpr std::size_t kLookedAt = 256;
constexpr double kAboutAsLong = 0.5;

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
  const RequestWork& work = requests_.at(task.request).work;
  Worker best = workers_.end();
  const auto rank = [&](Worker worker) {
    const auto threads = static_cast<double>(worker->second.info.threads);
    return std::tuple(worker->second.load / threads,
                      static_cast<double>(worker->second.tasks.size()) / threads,
                      warm_.warmth(work.scene, task.places, work.partners, worker->first));
  };
  for (auto worker = workers_.begin(); worker != workers_.end(); ++worker) {
    if (!has_room(worker->second, task) || !can_take(worker, task)) continue;
    if (task.is_suspect && !worker->second.tasks.empty()) continue;
    if (best == workers_.end() || rank(worker) < rank(best)) best = worker;
  }
  return best;
}

bool TaskBoard::can_take(Worker worker, const Task& task) const {
  return !task.refused_by.contains(worker->first) &&
         task.subproblem.size() <= worker->second.info.task_bytes;
}

void TaskBoard::prefer_warm(const Request& request, Worker worker, std::vector<TaskId>& waiting,
                            std::size_t next) const {
  const double shortest = kAboutAsLong * tasks_.at(waiting[next]).weight;
  const std::size_t end = std::min(waiting.size(), next + kLookedAt);
  std::size_t best = next;
  auto best_warmth = WarmRoadmaps::Warmth::kElsewhere;
  for (std::size_t i = next; i < end && best_warmth != WarmRoadmaps::Warmth::kWarm; ++i) {
    const Task& task = tasks_.at(waiting[i]);
    if (task.is_suspect || task.weight < shortest) break;
    if (!can_take(worker, task)) continue;
    const auto warmth =
        warm_.warmth(request.work.scene, task.places, request.work.partners, worker->first);
    if (warmth >= best_warmth) continue;
    best = i;
    best_warmth = warmth;
  }
  const auto at = waiting.begin() + static_cast<std::ptrdiff_t>(next);
  const auto chosen = waiting.begin() + static_cast<std::ptrdiff_t>(best);
  std::rotate(at, chosen, chosen + 1);
}

// Of so many tasks what one thread may be given at once: nobody's batch takes what others would
// idle for.
std::size_t TaskBoard::fair_share(std::size_t waiting) const {
  return std::clamp<std::size_t>(waiting / std::max<std::size_t>(1, threads()), 1, kBatchItems);
}

void TaskBoard::assign(Time now) {
  if (!may_assign_) return;
  may_assign_ = false;
  for (const bool is_ahead : {false, true}) {
    for (auto& [id, request] : requests_) assign(id, request, is_ahead, now);
  }
}

// Suspects go first, then long tasks, short ones in batches. Those ahead of need in the order in
// which they came, each for itself.
void TaskBoard::assign(RequestId request_id, Request& request, bool is_ahead, Time now) {
  std::vector<TaskId> waiting;
  for (const TaskId id : request.waiting) {
    Task& task = tasks_.at(id);
    if (task.is_ahead != is_ahead) continue;
    waiting.push_back(id);
    if (!task.waits_since) task.waits_since = now;
  }
  if (!is_ahead) {
    std::ranges::stable_sort(waiting, std::greater{}, [&](TaskId id) {
      return std::pair(tasks_.at(id).is_suspect, tasks_.at(id).weight);
    });
  }
  for (std::size_t next = 0; next < waiting.size();) {
    const Task& longest = tasks_.at(waiting[next]);
    const Worker worker = least_loaded(longest);
    if (worker == workers_.end()) {
      if (nobody_takes(longest)) {
        const std::string why = longest.last_trouble.empty() ? "it is larger than any worker takes"
                                                             : longest.last_trouble;
        finish(waiting[next], FinishedTask::How::kRefused, {}, {}, why);
      }
      ++next;
      continue;
    }
    WorkerRecord& record = worker->second;
    const std::size_t share = is_ahead ? 1 : fair_share(waiting.size() - next);
    TaskBatch batch{request_id, request.work.scene, {}, {}};
    double load = 0;
    std::size_t bytes = 0;
    for (; next < waiting.size() && batch.tasks.size() < share; ++next) {
      if (!is_ahead) prefer_warm(request, worker, waiting, next);
      Task& task = tasks_.at(waiting[next]);
      if (batch.tasks.empty()) batch.hierarchy = task.hierarchy;
      const double expected = task.weight * seconds_per_weight_;
      const bool fits = load + expected <= seconds(settings_.batch) &&
                        bytes + task.subproblem.size() <= kBatchBytes && can_take(worker, task) &&
                        task.hierarchy == batch.hierarchy && !task.is_suspect;
      if (!batch.tasks.empty() && !fits) break;
      task.load = expected;
      load += expected;
      bytes += task.subproblem.size();
      record.load += expected;
      record.tasks.insert(waiting[next]);
      if (is_ahead) record.ahead.insert(waiting[next]);
      warm_.add(request.work.scene, task.places, worker->first);
      request.waiting.erase(waiting[next]);
      batch.tasks.push_back({{waiting[next], task.epoch}, task.subproblem});
      ++counters_.assigned;
      counters_.waited.add(seconds(now - *std::exchange(task.waits_since, std::nullopt)));
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
    worker.revoked.add(revoke.tasks.back());
    drop_from(worker, id);
    ++task.epoch;
    task.sent.reset();
    requests_.at(task.request).waiting.insert(id);
    ++counters_.put_off;
  }
  if (!revoke.tasks.empty()) worker.outbox.emplace_back(std::move(revoke));
}

std::optional<TaskBoard::Outgoing> TaskBoard::next_outgoing(Time now) {
  assign(now);
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
