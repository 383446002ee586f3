// What happens on a task board, as it happens, for the log.
// A plain value that lives as long as the call which brings it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "common/transport/endpoint_id.h"
#include "common/transport/messages.h"
#include "coordinator/dispatch/board_counters.h"

namespace accord {

struct WorkerRecord;

struct BoardNote {
  enum class Kind : std::uint8_t {
    // A worker's standing has changed.
    kWelcomed,
    kLeaving,
    kRefused,
    kDistrusted,
    kLeft,
    kGone,
    kSilent,
    // Of a task.
    kAssigned,
    kReassigned,  // to whom is told when it is assigned
    kGivenUp,     // nobody can do it
    kDropped,     // its result, which nobody waits for
  };
  Kind kind = Kind::kWelcomed;
  EndpointId worker = {};                // 0: none
  const WorkerRecord* record = nullptr;  // the worker's, where it is about that
  std::string_view request = {};         // the task's, as its sender calls it
  std::optional<TaskKey> task = {};
  Reassigned reason = {};      // of kReassigned
  std::string_view text = {};  // why, for people
};

}  // namespace accord
