// What coordinator and workers say to each other: plain values. The wire's counterparts are in
// idl/accord.idl; docs/architecture.md tells the story.
//
// Every message may come twice, late, or not at all where its sender or the link fails. So each
// says which request, task and epoch it is about, and can be sent again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "common/io/wire/bytes.h"
#include "common/io/wire/scene_hash.h"

namespace accord {

// The protocol's major version: part of every topic's name but that of announcements.
inline constexpr std::uint32_t kProtocol = 1;

// One assignment of one task. The epoch tells assignments of a task apart: what a former assignee
// still says about it is late.
struct TaskKey {
  std::uint64_t task = 0;
  std::uint32_t epoch = 0;

  friend auto operator<=>(const TaskKey&, const TaskKey&) = default;
};

// ---- Coordinator to worker ----

struct TaskItem {
  TaskKey key;
  Bytes subproblem;  // subproblem_codec.h

  friend bool operator==(const TaskItem&, const TaskItem&) = default;
};

// Tasks of one request, to be solved in that order.
struct TaskBatch {
  std::uint64_t request = 0;
  SceneHash scene;
  Bytes hierarchy;  // subproblem_codec.h
  std::vector<TaskItem> tasks;

  friend bool operator==(const TaskBatch&, const TaskBatch&) = default;
};

struct Command {
  enum class Kind : std::uint8_t {
    kWelcome = 0,  // announced, and taken on
    kRefuse = 1,   // not taken on: `text` says why
    kAlive = 2,    // the coordinator's heartbeat
    kRevoke = 3,   // stop working on `tasks`; no result is expected
    kForget = 4,   // `scene` is not needed any more
  };
  Kind kind = Kind::kAlive;
  std::vector<TaskKey> tasks;
  SceneHash scene;
  std::string text;

  friend bool operator==(const Command&, const Command&) = default;
};

// Bytes [offset, offset + data.size()) of a scene's `total`; scene_pieces.h puts them together.
struct ScenePiece {
  SceneHash scene;
  std::uint64_t total = 0;
  std::uint64_t offset = 0;
  Bytes data;

  friend bool operator==(const ScenePiece&, const ScenePiece&) = default;
};

// ---- Worker to coordinator ----

// Who a worker is. Sent again until it is welcomed: to EndpointId{0}, all coordinators, whatever
// their protocol, so that one of another version can be told from one that is not there.
struct Announcement {
  std::uint32_t protocol = kProtocol;
  std::string version;            // of the program
  std::string host;               // for people
  std::uint32_t process = 0;      // its id there
  std::uint32_t threads = 0;      // tasks that it works on at once
  std::uint64_t task_bytes = 0;   // the largest subproblem that it takes
  std::uint64_t scene_bytes = 0;  // the largest scene
  bool leaving = false;           // takes no more tasks

  friend bool operator==(const Announcement&, const Announcement&) = default;
};

struct ResultItem {
  enum class Outcome : std::uint8_t {
    kDone = 0,        // `resolution` says how it went
    kHandedBack = 1,  // not begun, or stopped: the worker is leaving
    kRefused = 2,     // could not be decoded, or is beyond a limit: `text` says why
    kFailed = 3,      // the worker ran into trouble of its own: `text` says which
  };
  TaskKey key;
  Outcome outcome = Outcome::kDone;
  Bytes resolution;    // resolution_codec.h
  double seconds = 0;  // of work, by the worker's clock; for statistics only
  std::string text;

  friend bool operator==(const ResultItem&, const ResultItem&) = default;
};

struct ResultBatch {
  std::vector<ResultItem> results;

  friend bool operator==(const ResultBatch&, const ResultBatch&) = default;
};

struct TaskProgress {
  TaskKey key;
  bool begun = false;
  double seconds = 0;  // since it was begun

  friend bool operator==(const TaskProgress&, const TaskProgress&) = default;
};

// The worker is alive, and what it has in hand.
struct Heartbeat {
  std::uint32_t idle_threads = 0;
  std::vector<TaskProgress> tasks;

  friend bool operator==(const Heartbeat&, const Heartbeat&) = default;
};

// A scene that a task named is not here: its bytes from `offset` on are asked for.
struct SceneRequest {
  SceneHash scene;
  std::uint64_t offset = 0;

  friend bool operator==(const SceneRequest&, const SceneRequest&) = default;
};

using Message = std::variant<TaskBatch, Command, ScenePiece, Announcement, ResultBatch, Heartbeat,
                             SceneRequest>;
inline constexpr std::size_t kMessageKinds = std::variant_size_v<Message>;

}  // namespace accord
