// A worker as the coordinator knows it.
// Plain data and a queue; not thread safe.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "common/transport/bus.h"
#include "coordinator/dispatch/task.h"

namespace accord {

// Sends one scene to one worker, a piece at a time, as fast as its link takes them.
struct SceneDelivery {
  SceneHash scene;
  std::shared_ptr<const Bytes> bytes;
  std::uint64_t offset = 0;
};

// The latest of a worker's past, to know what a result is that nobody waits for.
class RecentTasks {
 public:
  void add(const TaskKey& key) {
    if (keys_.size() >= kMost) keys_.pop_front();
    keys_.push_back(key);
  }
  bool has(const TaskKey& key) const { return std::ranges::find(keys_, key) != keys_.end(); }

 private:
  static constexpr std::size_t kMost = 256;
  std::deque<TaskKey> keys_;
};

struct WorkerRecord {
  enum class Standing : std::uint8_t {
    kWelcome,
    kLeaving,     // takes no more tasks
    kDistrusted,  // gave a result that does not hold
    kRefused,     // of another protocol
  };

  Announcement info;
  Standing standing = Standing::kWelcome;
  std::string why;                     // not welcome
  Bus::Duration heard{0};              // the last time
  Bus::Duration greeted{0};            // when it was last told that the coordinator is alive
  Bus::Duration blocked_until{0};      // its link was full
  std::optional<Bus::Duration> beat;   // its last heartbeat
  std::uint32_t idle_threads = 0;      // as that says
  std::set<TaskId> tasks;              // in hand
  std::set<TaskId> begun;              // of these, as far as it has said
  std::set<TaskId> ahead;              // of these: not needed yet
  std::map<TaskId, unsigned> unheard;  // of these: heartbeats in a row that did not name them
  RecentTasks answered;                // whose results have come
  RecentTasks revoked;                 // that were taken back from it, as nobody needs them
  bool is_alone_with_suspect = false;  // its only task is one that others may have died of
  double load = 0;                     // s: what is expected of them
  std::deque<Message> outbox;
  std::optional<SceneDelivery> delivery;  // after what is in the outbox
  std::set<SceneHash> scenes;             // that it has asked for
};

}  // namespace accord
