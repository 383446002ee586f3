// What accord-worker can be told.
#pragma once

#include "common/runtime/process_settings.h"
#include "common/runtime/settings.h"
#include "common/transport/dds_options.h"

namespace accord {

struct WorkerSettings {
  unsigned threads = cores();  // subproblems solved at once
  DdsOptions dds;
  LogOptions log;
  MetricsOptions metrics;
};

// The table that is bound to `settings`, which must outlive it.
Settings worker_table(WorkerSettings& settings);

}  // namespace accord
