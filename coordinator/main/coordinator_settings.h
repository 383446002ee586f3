// What accord-coordinator can be told.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "common/runtime/process_settings.h"
#include "common/runtime/settings.h"
#include "common/transport/dds_options.h"
#include "common/transport/ros/ros_options.h"

namespace accord {

// What the service takes on, at most. Beyond it requests are rejected, with a reason.
struct CoordinatorLimits {
  std::size_t queued = 1000;                          // requests that wait
  unsigned planning;                                  // requests planned at once
  std::size_t request_bytes = std::size_t{16} << 20;  // of one request, scene and files together
  std::size_t robots = 10'000;                        // of one request
  std::size_t waypoints = 10'000'000;                 // of one finished plan

  CoordinatorLimits();
};

struct CoordinatorSettings {
  DdsOptions dds;
  std::string journal;                         // the SQLite file; empty: in memory, so that a
                                               // restart forgets all requests
  std::chrono::milliseconds keep{86'400'000};  // finished plans, from when they are finished
  std::string scenes;                          // folder of stored scenes; empty: none
  CoordinatorLimits limits;
  unsigned threads = cores();             // for proofs
  std::chrono::milliseconds lease{1000};  // of silence, until a worker is given up
  unsigned deaths = 3;                    // of workers, that quarantine a task
  std::string quarantine = "auto";        // see quarantine_folder()
  RosOptions ros;
  LogOptions log;
  MetricsOptions metrics;

  // Where inputs of quarantined tasks are written; empty: nowhere. "auto" is the journal's path
  // with ".quarantine" behind it, and nowhere without a journal.
  std::string quarantine_folder() const;
};

// The table that is bound to `settings`, which must outlive it.
Settings coordinator_table(CoordinatorSettings& settings);

}  // namespace accord
