#include "common/runtime/process_settings.h"

#include <string_view>

namespace accord {
namespace {

constexpr std::string_view kNone = "none";
constexpr std::string_view kAny = "any";

Notation<std::optional<std::uint16_t>> metrics_port() {
  const auto number = whole_number<std::uint16_t>(0, UINT16_MAX);
  using Port = std::optional<std::uint16_t>;
  return {"a whole number from 1 to 65535, any for one that is free, or none", "PORT",
          [number](std::string_view text) -> std::optional<Port> {
            if (text == kAny) return Port(0);
            // 0 is what other programs call none.
            if (text == kNone || text == "0") return Port(std::nullopt);
            const auto port = number.parse(text);
            if (!port) return std::nullopt;
            return Port(*port);
          },
          [number](const Port& port) {
            if (!port) return std::string(kNone);
            return *port == 0 ? std::string(kAny) : number.print(*port);
          }};
}

}  // namespace

void add_log_settings(Settings& settings, LogOptions& log) {
  settings.add("log.level", "--log", log.level, one_of<LogLevel>(kLogLevels),
               "Least level of what is logged to stderr");
  settings.add("log.format", "--log-format", log.format, one_of<LogFormat>(kLogFormats),
               "What lines of the log look like");
}

void add_metrics_settings(Settings& settings, MetricsOptions& metrics) {
  settings.add("metrics.port", "--metrics", metrics.port, metrics_port(),
               "Port for /metrics, /healthz and /readyz");
  settings.add("metrics.address", "--metrics-address", metrics.address, ipv4_address(),
               "Address of this machine to serve them at, 0.0.0.0 for all");
  settings.add("metrics.port_file", "--metrics-port-file", metrics.port_file,
               path_or_none("a file", "FILE"), "Where the port is written, for accord health");
}

}  // namespace accord
