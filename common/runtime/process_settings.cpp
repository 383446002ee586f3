#include "common/runtime/process_settings.h"

#include <algorithm>
#include <thread>

namespace accord {

void add_log_settings(Settings& settings, LogOptions& log) {
  settings.add("log.level", "--log", log.level, one_of<LogLevel>(kLogLevels),
               "Least level of what is logged to stderr");
  settings.add("log.format", "--log-format", log.format, one_of<LogFormat>(kLogFormats),
               "What lines of the log look like");
}

void add_metrics_settings(Settings& settings, MetricsOptions& metrics) {
  settings.add("metrics.port", "--metrics", metrics.port,
               whole_number<std::uint16_t>(0, UINT16_MAX),
               "Port for /metrics, /healthz and /readyz, 0 for none");
  settings.add("metrics.address", "--metrics-address", metrics.address, ipv4_address(),
               "Address of this machine to serve them at, 0.0.0.0 for all");
}

unsigned cores() {
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace accord
