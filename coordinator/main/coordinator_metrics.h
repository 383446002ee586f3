// What /metrics says of a coordinator.
#pragma once

#include "common/runtime/metrics.h"
#include "coordinator/service/service_tally.h"

namespace accord {

// Adds them, read off the tally whenever they are asked for; it must outlive `metrics`.
void add_coordinator_metrics(Metrics& metrics, const ServiceTally& tally);

}  // namespace accord
