// What accord-discovery can be told.
#pragma once

#include "common/runtime/process_settings.h"
#include "common/runtime/settings.h"
#include "common/transport/dds_discovery.h"

namespace accord {

struct DiscoverySettings {
  DiscoveryServerOptions server;
  LogOptions log;
  MetricsOptions metrics;
};

// The table that is bound to `settings`, which must outlive it.
Settings discovery_table(DiscoverySettings& settings);

}  // namespace accord
