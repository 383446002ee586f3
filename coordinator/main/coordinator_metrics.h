// What /metrics says of a coordinator. docs/operations.md tells what each means, and
// tests/system/monitoring/ compares.
#pragma once

#include <string>

#include "common/runtime/metric_readings.h"
#include "coordinator/service/service_tally.h"

namespace accord {

// Adds them, read off the tally whenever they are asked for; it must outlive `metrics`.
// `journal`: its file; empty: there is none.
void add_coordinator_metrics(Metrics& metrics, const ServiceTally& tally,
                             const std::string& journal);

// Parts of it. Every series is there from the beginning on, with 0.
using CoordinatorReadings = MetricReadings<ServiceTally::Totals>;
void add_request_metrics(CoordinatorReadings& add);
void add_planning_metrics(CoordinatorReadings& add);
void add_task_metrics(CoordinatorReadings& add);
void add_worker_pool_metrics(CoordinatorReadings& add);
void add_message_metrics(CoordinatorReadings& add);

}  // namespace accord
