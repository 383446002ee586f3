// The settings that every service has: its log and its metrics.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/runtime/cores.h"
#include "common/runtime/log.h"
#include "common/runtime/settings.h"

namespace accord {

struct MetricsOptions {
  std::optional<std::uint16_t> port;  // TCP; 0: any that is free; nullopt: none are served
  std::string address = "127.0.0.1";  // IPv4, of this machine, to listen on; 0.0.0.0: all
  std::string port_file;              // where the port is written; empty: nowhere
};

// log.level and log.format; metrics.port, metrics.address and metrics.port_file.
void add_log_settings(Settings& settings, LogOptions& log);
void add_metrics_settings(Settings& settings, MetricsOptions& metrics);

// The words for a default of cores().
inline constexpr const char* kOneForEachCore = "one for each core";

}  // namespace accord
