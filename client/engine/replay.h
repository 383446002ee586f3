// Solves one recorded task again, inside this process, as a worker would, and checks what comes out
// as a coordinator would.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "common/io/wire/task_record.h"

namespace accord {

struct Replay {
  enum class Outcome {
    kSolved,
    kImproved,   // a crowd, but for the robots that the resolution leaves
    kExhausted,  // by all of its solvers
    kRefused,    // the resolution does not hold
    kStopped,    // by the deadline, or cancelled
  };
  Outcome outcome = Outcome::kExhausted;
  Resolution resolution;
  std::string fault;   // of a resolution that is refused
  double seconds = 0;  // wall clock, of solving
};

// `timeout` (s, wall clock) and `cancel`, which may be null, end it. A sentence: the record names a
// solver that does not exist. Thread safe.
tl::expected<Replay, std::string> replay(const RecordedTask& task, std::optional<double> timeout,
                                         const std::atomic<bool>* cancel);

}  // namespace accord
