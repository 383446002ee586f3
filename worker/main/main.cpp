// accord-worker: solves subproblems for a coordinator on the same DDS domain.
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <memory>
#include <string>
#include <utility>

#include "common/io/limits.h"
#include "common/runtime/command_line.h"
#include "common/runtime/ending_signals.h"
#include "common/runtime/host_name.h"
#include "common/runtime/log.h"
#include "common/runtime/metrics.h"
#include "common/runtime/metrics_endpoint.h"
#include "common/runtime/process_main.h"
#include "common/runtime/process_metrics.h"
#include "common/transport/dds_bus.h"
#include "worker/main/worker_metrics.h"
#include "worker/main/worker_settings.h"
#include "worker/service/worker_loop.h"

namespace {

using accord::ProcessExit;

accord::TaskDesk::Settings desk_settings(const accord::WorkerSettings& options) {
  accord::TaskDesk::Settings settings;
  settings.info.version = ACCORD_VERSION;
  settings.info.host = accord::host_name();
  settings.info.process = static_cast<std::uint32_t>(getpid());
  settings.info.threads = options.threads;
  settings.info.task_bytes = accord::limits::kSubproblemBytes;
  settings.info.scene_bytes = accord::limits::kSceneWireBytes;
  return settings;
}

// Joins the bus and works; again, where it has been forgotten.
ProcessExit work(const accord::WorkerSettings& options, accord::WorkerTally& tally,
                 accord::EndingSignals& signals) {
  while (true) {
    auto bus = accord::make_dds_bus(accord::Role::kWorker, options.dds);
    if (!bus) {
      spdlog::error("{}", bus.error());
      return ProcessExit::kUnavailable;
    }
    const std::string id = to_string((*bus)->self());
    const accord::LogScope of_worker({{"worker", id}});
    spdlog::info("worker {} with {} threads in domain {}, cluster {}", id, options.threads,
                 options.dds.domain, options.dds.cluster);
    accord::WorkerLoop loop(**bus, desk_settings(options), tally);
    signals.set([&loop] { loop.drain(); });
    const auto end = loop.run();
    signals.set(nullptr);
    if (end == accord::WorkerLoop::End::kDrained) return ProcessExit::kEnded;
    spdlog::info("no coordinator answers any more: joins anew");
  }
}

ProcessExit run(int argc, char** argv) {
  accord::WorkerSettings options;
  const accord::Start start = accord::start_up(
      {"accord-worker", "Solves subproblems for an Accord coordinator.", ACCORD_VERSION},
      accord::worker_table(options), argc, argv);
  if (start.end) return *start.end;
  accord::start_log("accord-worker", options.log);
  for (const std::string& warning : start.warnings) spdlog::warn("{}", warning);

  accord::EndingSignals signals;
  accord::WorkerTally tally;
  accord::Metrics metrics;
  accord::add_process_metrics(metrics, ACCORD_VERSION);
  accord::add_worker_metrics(metrics, tally, options.threads);
  const auto server = accord::serve_metrics(
      options.metrics, metrics,
      {[&tally] { return tally.is_alive(); }, [&tally] { return tally.is_ready(); }});
  if (!server) {
    spdlog::error("{}", server.error());
    return ProcessExit::kUnavailable;
  }
  const ProcessExit code = work(options, tally, signals);
  spdlog::info("ended");
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  return accord::process_main("accord-worker", [&] { return run(argc, argv); });
}
