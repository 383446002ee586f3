#include "discovery/main/discovery_settings.h"

#include "common/transport/dds_settings.h"

namespace accord {

Settings discovery_table(DiscoverySettings& settings) {
  Settings table;
  add_discovery_server_settings(table, settings.server);
  add_log_settings(table, settings.log);
  add_metrics_settings(table, settings.metrics);
  return table;
}

}  // namespace accord
