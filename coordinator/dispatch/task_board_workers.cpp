// What workers say of themselves, and when they are given up.
#include <algorithm>
#include <utility>

#include "coordinator/dispatch/task_board.h"

namespace accord {

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

// A worker names all that it has in hand. What it has been sent, and does not name time and again,
// has not reached it, or its result has not come back.
void TaskBoard::on_heartbeat(WorkerRecord& worker, const Heartbeat& heartbeat, Time now) {
  constexpr unsigned kUnheard = 3;
  count_busy(worker, heartbeat, now);
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
    take_back(id, Reassigned::kUnheard, false, "it got lost on its way");
  }
}

// Each heartbeat speaks for the time since the last one.
void TaskBoard::count_busy(WorkerRecord& worker, const Heartbeat& heartbeat, Time now) {
  worker.idle_threads = std::min(heartbeat.idle_threads, worker.info.threads);
  if (worker.beat) {
    const double time = std::chrono::duration<double>(now - *worker.beat).count();
    counters_.thread_seconds += time * worker.info.threads;
    counters_.busy_seconds += time * (worker.info.threads - worker.idle_threads);
  }
  worker.beat = now;
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
void TaskBoard::give_up(EndpointId id, GivenUp reason, const std::string& why) {
  const auto found = workers_.find(id);
  if (found == workers_.end()) return;
  WorkerRecord& worker = found->second;
  const bool is_lost = reason != GivenUp::kDistrusted;
  const bool is_missed =
      worker.standing == WorkerRecord::Standing::kWelcome || !worker.tasks.empty();
  std::set<TaskId> begun = std::exchange(worker.begun, {});
  const std::set<TaskId> tasks = std::exchange(worker.tasks, {});
  worker.ahead.clear();
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
    const bool had_begun = is_lost && begun.contains(task);
    if (had_begun) tasks_.at(task).is_suspect = true;
    take_back(task, is_lost ? Reassigned::kWorkerLost : Reassigned::kDistrusted,
              had_begun && (begun.size() == 1 || tasks_.at(task).is_ahead), trouble);
  }
  if (!is_lost) return;
  ++(!is_missed                   ? counters_.workers_left
     : reason == GivenUp::kSilent ? counters_.workers_silent
                                  : counters_.workers_gone);
  warm_.forget(id);
  workers_.erase(found);
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
  for (const EndpointId id : silent) {
    give_up(id, GivenUp::kSilent, "was silent for too long");
  }
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
}  // namespace accord
