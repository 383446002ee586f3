// What /metrics says of a worker. docs/operations.md tells what each means, and
// tests/system/monitoring/ compares.
#pragma once

#include "common/runtime/metrics.h"
#include "worker/service/worker_tally.h"

namespace accord {

// Adds them, read off the tally whenever they are asked for; it must outlive `metrics`.
void add_worker_metrics(Metrics& metrics, const WorkerTally& tally, unsigned threads);

}  // namespace accord
