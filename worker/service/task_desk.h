// A worker's books: what it has been given, by whom, which scenes it has, what it has to say. A
// state machine: events and the time go in, jobs and messages come out. No threads, no DDS, no
// clock; whoever owns it solves the jobs.
//
// What it promises:
//   * it announces itself until a coordinator welcomes it, and again when that one falls silent or
//     comes back: then what it had from it before is dropped;
//   * every job that is not revoked ends with one result, sent again and again never: a coordinator
//     that misses it gives the task out anew;
//   * a leaving worker hands back what it has not begun, and finishes the rest.
//
// Not thread safe: one loop owns it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/transport/bus.h"
#include "common/transport/scene_pieces.h"

namespace accord {

class TaskDesk {
 public:
  // Since a beginning of the caller's choice; must not go back.
  using Time = Bus::Duration;

  struct Settings {
    Announcement info;                                // threads, limits, names
    Time heartbeat = std::chrono::milliseconds(100);  // of its own, and of announcements
    Time patience = std::chrono::milliseconds(400);   // with a silent coordinator, and for a piece
                                                      // of a scene
    Time retry = std::chrono::milliseconds(2);        // after a full link
  };

  // One task, to be solved.
  struct Job {
    EndpointId coordinator;
    TaskKey key;
    SceneHash scene;
    Bytes hierarchy;
    Bytes subproblem;
  };

  explicit TaskDesk(Settings settings) : settings_(std::move(settings)) {}

  // ---- Work ----

  // The next job, if a thread is idle and its scene is here.
  std::optional<Job> next_job(Time now);
  // How a job ended. Of a revoked one nothing is said.
  void on_ended(const Job& job, ResultItem result);
  // Jobs that run and need not: stop them, then say how they ended.
  std::vector<TaskKey> take_revoked();

  // A scene's bytes, complete and with the right hash, to be made ready.
  struct Scene {
    SceneHash hash;
    Bytes bytes;
  };
  std::optional<Scene> take_scene();
  // It can be worked with; or not, and why.
  void on_scene_ready(const SceneHash& scene);
  void on_scene_unusable(const SceneHash& scene, const std::string& why);
  // Scenes that nobody needs any more.
  std::vector<SceneHash> take_forgotten();

  // From now on no more tasks. Done when is_idle().
  void leave();
  bool is_leaving() const { return leaving_; }
  std::size_t running() const { return running_.size(); }
  std::size_t waiting() const { return waiting_.size(); }
  bool is_idle() const { return waiting_.empty() && running_.empty() && outbox_.empty(); }

  // ---- The network ----

  void on_event(const BusEvent& event, Time now);
  void on_time(Time now);
  std::optional<Time> next_deadline() const;

  struct Outgoing {
    EndpointId to;  // 0: all coordinators
    const Message& message;
  };
  std::optional<Outgoing> next_outgoing(Time now) const;
  void on_published(Published outcome, Time now);

  std::optional<EndpointId> coordinator() const { return coordinator_; }
  // Why a coordinator would not have this worker; empty: none has refused it.
  const std::string& refusal() const { return refusal_; }

 private:
  struct Pending {
    EndpointId to;
    Message message;
  };
  struct Running {
    Job job;
    Time since;
    bool revoked = false;
  };
  struct Wanted {
    SceneAssembly assembly;
    Time asked;
  };

  void on_batch(EndpointId from, const TaskBatch& batch, Time now);
  void on_command(EndpointId from, const Command& command, Time now);
  void on_piece(const ScenePiece& piece, Time now);
  void want(const SceneHash& scene, Time now);
  void drop_coordinator();
  void announce();
  void say_alive(Time now);
  void send(EndpointId to, Message message) { outbox_.push_back({to, std::move(message)}); }
  void answer(const TaskKey& key, ResultItem::Outcome outcome, const std::string& text);

  Settings settings_;
  std::optional<EndpointId> coordinator_;
  std::string refusal_;
  Time heard_{0};     // from the coordinator
  Time speak_at_{0};  // when to announce, or to say that it is alive
  Time blocked_until_{0};
  bool leaving_ = false;
  std::deque<Job> waiting_;
  std::vector<Running> running_;
  std::map<SceneHash, Wanted> wanted_;  // asked for
  std::deque<Scene> arrived_;
  std::set<SceneHash> making_ready_;
  std::set<SceneHash> ready_;
  std::vector<SceneHash> forgotten_;
  std::vector<TaskKey> revoked_;
  std::deque<Pending> outbox_;
};

}  // namespace accord
