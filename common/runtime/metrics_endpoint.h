// Where a process serves its metrics, as it was told: one call for the mains of services; and how
// others ask it whether it is well.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "common/runtime/metrics_server.h"
#include "common/runtime/process_settings.h"

namespace accord {

// Serves (metrics_server.h), logs where, and writes the port to `options.port_file`. nullptr where
// none are wanted; a sentence where it cannot.
tl::expected<std::unique_ptr<MetricsServer>, std::string> serve_metrics(
    const MetricsOptions& options, Metrics& metrics, MetricsServer::Probes probes);

// The port that a process on this machine serves at, going by what it was told or has written to
// its file; or a sentence that says why that is not known.
tl::expected<std::uint16_t, std::string> metrics_port_of(const MetricsOptions& options);

struct HealthAnswer {
  bool is_well = false;
  std::string text;  // what it says, without its last newline; from the network: anything
};

// Asks a process: "/healthz" whether it is alive, "/readyz" whether it can work. Or a sentence that
// says why there was no answer. Blocks for `patience` at most, once connected.
tl::expected<HealthAnswer, std::string> ask_health(const std::string& address, std::uint16_t port,
                                                   const std::string& path,
                                                   std::chrono::milliseconds patience);

}  // namespace accord
