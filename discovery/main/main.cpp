// accord-discovery: where coordinators, workers and fleet managers ask for each other on networks
// without multicast.
#include <spdlog/spdlog.h>

#include <future>
#include <memory>
#include <string>
#include <utility>

#include "common/runtime/command_line.h"
#include "common/runtime/ending_signals.h"
#include "common/runtime/log.h"
#include "common/runtime/metrics.h"
#include "common/runtime/metrics_endpoint.h"
#include "common/runtime/process_main.h"
#include "common/runtime/process_metrics.h"
#include "common/transport/dds_discovery.h"
#include "discovery/main/discovery_settings.h"

namespace accord {
namespace {

ProcessExit fail(const std::string& why) {
  spdlog::error("{}", why);
  return ProcessExit::kUnavailable;
}

// Tells the log and the metrics of who comes and goes.
class Reporter {
 public:
  explicit Reporter(Metrics& metrics)
      : participants_(metrics.gauge("accord_discovery_participants",
                                    "DDS participants that ask the discovery server")) {}

  void operator()(const DiscoveryServer::Change& change) {
    participants_.set(static_cast<double>(change.present));
    const LogScope of_participant({{"participant", change.who}, {"present", change.present}});
    spdlog::info("{} {}", change.who.empty() ? "somebody who is not Accord's" : change.who,
                 change.is_there ? "has come" : "has gone");
  }

 private:
  Metrics::Gauge participants_;
};

ProcessExit serve(const DiscoverySettings& settings) {
  EndingSignals signals;
  std::promise<void> asked_to_end;
  signals.set([&asked_to_end] { asked_to_end.set_value(); });
  Metrics metrics;
  add_process_metrics(metrics, ACCORD_VERSION);
  const auto metrics_server = serve_metrics(settings.metrics, metrics, {});
  if (!metrics_server) return fail(metrics_server.error());
  const auto server = make_dds_discovery_server(settings.server, Reporter(metrics));
  if (!server) return fail(server.error());
  spdlog::info("discovery server {} in domain {}", settings.server.id, settings.server.domain);
  asked_to_end.get_future().wait();
  signals.set(nullptr);
  spdlog::info("ended");
  return ProcessExit::kEnded;
}

ProcessExit run(int argc, const char* const* argv) {
  DiscoverySettings settings;
  const Start start =
      start_up({"accord-discovery", "Lets Accord's processes find each other without multicast.",
                ACCORD_VERSION},
               discovery_table(settings), argc, argv);
  if (start.end) return *start.end;
  start_log("accord-discovery", settings.log);
  for (const std::string& warning : start.warnings) spdlog::warn("{}", warning);
  return serve(settings);
}

}  // namespace
}  // namespace accord

int main(int argc, char** argv) {
  return accord::process_main("accord-discovery", [&] { return accord::run(argc, argv); });
}
