// What a person can say of DDS: the settings dds.*, in a file, a variable or a flag.
#pragma once

#include "common/runtime/settings.h"
#include "common/transport/dds_options.h"

namespace accord {

struct DiscoveryServerOptions;

// Adds a setting for each option, but for the protocol, which is not for people; and a check that
// they go together. `options` must outlive the table.
void add_dds_settings(Settings& settings, DdsOptions& options);

// Those of a discovery server: listen, id and some of dds.*.
void add_discovery_server_settings(Settings& settings, DiscoveryServerOptions& options);

}  // namespace accord
