// The coordinator's books: which task is whose, who is alive, what is to be said to whom. A state
// machine: events and the time go in, messages and finished tasks come out. No threads, no DDS, no
// clock; the same events at the same times give the same messages.
//
// What it promises, as long as there are workers:
//   * every task that was added, and not cancelled, finishes exactly once;
//   * a task's result is taken from the worker it is assigned to, in its present epoch: what a
//     worker that was given up still says is late and dropped;
//   * what a link has swallowed, a task or its result, is noticed from heartbeats, and done again;
//   * a task whose workers die of it is given out a few times only (Settings::deaths), then it is
//     finished as quarantined, so that it cannot take down one worker after the other. Where a
//     worker had begun several, each of these goes to a worker of its own next, to find the one;
//   * of tasks that take about as long, a worker gets those whose roadmaps it has built before;
//   * tasks ahead of need delay no others: they are given to idle threads only, taken back where a
//     task that is needed finds no other, and given up after the first death.
// Who gets which task, and when, depends on speeds and deaths; what comes back must not (that
// solvers are deterministic is their own business).
//
// Not thread safe: one loop owns it.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/transport/bus.h"
#include "coordinator/dispatch/board_counters.h"
#include "coordinator/dispatch/task.h"
#include "coordinator/dispatch/warm_roadmaps.h"
#include "coordinator/dispatch/worker_record.h"

namespace accord {

class TaskBoard {
 public:
  // Since a beginning of the caller's choice; must not go back.
  using Time = Bus::Duration;

  struct Settings {
    Time lease = std::chrono::milliseconds(1000);     // silent for so long: given up
    Time heartbeat = std::chrono::milliseconds(100);  // of the coordinator's own
    Time batch = std::chrono::milliseconds(2);        // of expected work that travels together
    Time retry = std::chrono::milliseconds(2);        // after a full link
    unsigned deaths = 3;                              // of workers, that quarantine a task
    std::size_t idle_scenes = 4;  // that workers keep, with their roadmaps, for requests to come
  };

  using Counters = BoardCounters;
  // What it has in hand.
  struct Load {
    std::size_t waiting = 0;   // tasks
    std::size_t assigned = 0;  // tasks
    Time oldest{0};            // how long the oldest that is needed has waited
    std::size_t threads = 0;   // of workers that get tasks
    std::size_t busy = 0;      // of these, as their last heartbeats say
    std::map<WorkerRecord::Standing, std::size_t> workers;
  };

  explicit TaskBoard(const Settings& settings) : settings_(settings) {}

  // ---- Work ----

  // Requires: `work.request` and the tasks' ids are new; weights are positive.
  void add(RequestWork work, std::vector<NewTask> tasks);
  // More of a request that is there.
  void add(RequestId request, std::vector<NewTask> tasks);
  // Its tasks are dropped, and revoked from whoever works on them. Nothing happens where the
  // request is not there.
  void end(RequestId request);
  // The same for some tasks. Nothing happens to those that are not there, or were taken.
  void cancel(const std::vector<TaskId>& tasks);
  // They are not ahead of need any more.
  void hurry(const std::vector<TaskId>& tasks);
  // Of all workers that get tasks.
  std::size_t threads() const;
  // In the order in which they finished. Of one that is kDone, say whether its result holds:
  // accept() or reject().
  std::optional<FinishedTask> take_finished();
  // The task is done with. Nothing happens where its request has ended.
  void accept(TaskId task);
  // The result does not hold: whoever said so gets no more tasks, and the task is done again.
  // Requires: it is kDone, and was not accepted.
  void reject(const FinishedTask& finished, const std::string& why);

  // ---- The network ----

  void on_event(const BusEvent& event, Time now);
  // Gives up on the silent. To be called when next_deadline() has come; sooner does no harm.
  void on_time(Time now);
  std::optional<Time> next_deadline() const;

  struct Outgoing {
    EndpointId to;
    const Message& message;
  };
  // What is to be sent next; nullopt: nothing, or not before the next deadline. Say what became of
  // it with on_published() before asking again.
  std::optional<Outgoing> next_outgoing(Time now);
  void on_published(EndpointId to, Published outcome, Time now);

  const Counters& counters() const { return counters_; }
  const std::map<EndpointId, WorkerRecord>& workers() const { return workers_; }
  std::size_t unfinished() const { return unfinished_; }
  Load load(Time now) const;

 private:
  struct Task {
    RequestId request = 0;
    Bytes hierarchy;
    Bytes subproblem;
    double weight = 1;
    bool is_ahead = false;
    std::vector<RoadmapPlace> places;
    double load = 0;  // s: what it was expected to take when it was assigned
    std::uint32_t epoch = 0;
    std::optional<Time> waits_since;  // as far as it has been looked at
    std::optional<Time> sent;         // to whom it is assigned
    bool is_suspect = false;          // a worker was lost that had begun it, and others
    unsigned deaths = 0;              // of workers that had begun nothing else
    std::set<EndpointId> refused_by;
    std::string last_trouble;
  };
  struct Request {
    RequestWork work;
    std::set<TaskId> waiting;
  };

  void on_announcement(EndpointId id, const Announcement& announcement, Time now);
  void on_result(EndpointId id, WorkerRecord& worker, const ResultItem& item);
  void on_heartbeat(WorkerRecord& worker, const Heartbeat& heartbeat, Time now);
  void count_busy(WorkerRecord& worker, const Heartbeat& heartbeat, Time now);
  void on_scene_request(WorkerRecord& worker, const SceneRequest& request);
  enum class GivenUp : std::uint8_t { kGone, kSilent, kDistrusted };
  void give_up(EndpointId id, GivenUp reason, const std::string& why);
  // Back among those that wait, under a new epoch, if it has not died too often.
  void take_back(TaskId id, Reassigned reason, bool is_to_blame, const std::string& why);
  void count_dropped(const WorkerRecord& worker, const TaskKey& key);
  void finish(TaskId id, FinishedTask::How how, Bytes resolution, EndpointId worker,
              std::string text);
  void drop_from(WorkerRecord& worker, TaskId id);
  void forget(const SceneHash& scene);
  bool drop_finished(TaskId id);
  void assign(Time now);
  void assign(RequestId id, Request& request, bool is_ahead, Time now);
  // Takes back tasks ahead of need that would keep needed ones waiting.
  void make_way(WorkerRecord& worker);
  using Worker = std::map<EndpointId, WorkerRecord>::iterator;
  Worker least_loaded(const Task& task);
  // Of the waiting tasks from `next` on, puts the one there that the worker is prepared for best.
  void prefer_warm(const Request& request, Worker worker, std::vector<TaskId>& waiting,
                   std::size_t next) const;
  bool can_take(Worker worker, const Task& task) const;
  bool has_room(const WorkerRecord& worker, const Task& task) const;
  bool nobody_takes(const Task& task) const;
  std::size_t fair_share(std::size_t waiting) const;

  Settings settings_;
  Counters counters_;
  std::map<TaskId, Task> tasks_;  // and finished ones that are not accepted yet
  std::size_t unfinished_ = 0;
  std::map<RequestId, Request> requests_;  // in the order in which they came
  std::map<EndpointId, WorkerRecord> workers_;
  WarmRoadmaps warm_;
  std::deque<SceneHash> idle_scenes_;  // of no request any more; the longest first
  std::deque<FinishedTask> finished_;
  double seconds_per_weight_ = 1e-3;  // as measured; decides who gets what, never what comes back
  bool may_assign_ = false;           // something has changed since it was tried
  std::optional<EndpointId> last_sender_;  // whose turn to be sent to was last
};

}  // namespace accord
