// The settings that every service has: its log and its metrics.
#pragma once

#include <cstdint>
#include <string>

#include "common/runtime/log.h"
#include "common/runtime/settings.h"

namespace accord {

struct MetricsOptions {
  std::uint16_t port = 0;             // TCP; 0: none are served
  std::string address = "127.0.0.1";  // IPv4, of this machine, to listen on; 0.0.0.0: all
};

// log.level and log.format; metrics.port and metrics.address.
void add_log_settings(Settings& settings, LogOptions& log);
void add_metrics_settings(Settings& settings, MetricsOptions& metrics);

// How many threads this machine runs at once; at least 1. The words for such a default.
unsigned cores();
inline constexpr const char* kOneForEachCore = "one for each core";

}  // namespace accord
