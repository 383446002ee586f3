// accord-coordinator: takes requests for plans, owns paths and conflicts, and gives subproblems to
// workers on the same DDS domain.
#include <chrono>
#include <csignal>
#include <memory>
#include <string>

#include <spdlog/spdlog.h>

#include "common/planning/method_names.h"
#include "common/runtime/command_line.h"
#include "common/runtime/ending_signals.h"
#include "common/runtime/host_name.h"
#include "common/runtime/log.h"
#include "common/runtime/metrics.h"
#include "common/runtime/metrics_endpoint.h"
#include "common/runtime/process_main.h"
#include "common/runtime/process_metrics.h"
#include "common/transport/dds_bus.h"
#include "common/transport/fleet/dds_fleet.h"
#include "coordinator/journal/memory_journal.h"
#include "coordinator/journal/sqlite_journal.h"
#include "coordinator/main/coordinator_metrics.h"
#include "coordinator/main/coordinator_settings.h"
#include "coordinator/service/coordinator_loop.h"

namespace accord {
namespace {

tl::expected<std::unique_ptr<Journal>, std::string> open_journal(
    const CoordinatorSettings& settings) {
  if (settings.journal.empty()) {
    spdlog::warn("no journal: what is accepted is lost when this process ends");
    return std::make_unique<MemoryJournal>();
  }
  auto journal = SqliteJournal::open(settings.journal);
  if (!journal) return tl::unexpected(std::move(journal.error()));
  return std::move(*journal);
}

CoordinatorLoop::Settings loop_settings(const CoordinatorSettings& settings) {
  CoordinatorLoop::Settings out;
  out.version = ACCORD_VERSION;
  out.host = host_name();
  out.board.lease = settings.lease;
  out.board.deaths = settings.deaths;
  out.desk.queued = settings.limits.queued;
  out.desk.planning = settings.limits.planning;
  out.desk.waypoints = settings.limits.waypoints;
  out.desk.threads = settings.threads;
  out.desk.keep = std::chrono::duration<double>(settings.keep).count();
  out.desk.outlives = !settings.journal.empty();
  out.planning.planning = settings.limits.planning;
  out.planning.threads = settings.threads;
  out.planning.scenes = settings.scenes;
  out.planning.quarantine = settings.quarantine_folder();
  out.planning.limits.bytes = settings.limits.request_bytes;
  out.planning.limits.robots = settings.limits.robots;
  out.planning.limits.methods = method_names();
  out.planning.limits.solvers = local_solver_names();
  return out;
}

ProcessExit fail(const std::string& why) {
  spdlog::error("{}", why);
  return ProcessExit::kUnavailable;
}

MetricsServer::Probes probes(const ServiceTally& tally) {
  return {[&tally] { return tally.is_alive(); }, [&tally] { return tally.is_ready(); }};
}

ProcessExit serve(const CoordinatorSettings& settings) {
  EndingSignals signals;
  // A file that may not grow is a full disk, which the journal reports; it must not kill.
  std::signal(SIGXFSZ, SIG_IGN);
  ServiceTally tally;
  Metrics metrics;
  add_process_metrics(metrics, ACCORD_VERSION);
  add_coordinator_metrics(metrics, tally, settings.journal);
  const auto server = serve_metrics(settings.metrics, metrics, probes(tally));
  if (!server) return fail(server.error());
  const auto journal = open_journal(settings);
  if (!journal) return fail(journal.error());
  const auto bus = make_dds_bus(Role::kCoordinator, settings.dds);
  if (!bus) return fail(bus.error());
  const auto fleet = make_dds_fleet_service(
      settings.dds, [&bus] { (*bus)->wake(); }, settings.ros);
  if (!fleet) return fail(fleet.error());
  spdlog::info("coordinator {} in domain {}, cluster {}", to_string((*bus)->self()),
               settings.dds.domain, settings.dds.cluster);
  CoordinatorLoop loop(loop_settings(settings), **bus, **fleet, **journal, tally);
  signals.set([&loop] { loop.drain(); });
  const auto fault = loop.run();
  signals.set(nullptr);
  if (fault) return fail(*fault);
  spdlog::info("ended");
  return ProcessExit::kEnded;
}

ProcessExit run(int argc, const char* const* argv) {
  CoordinatorSettings settings;
  const Start start =
      start_up({"accord-coordinator", "Plans for fleets of robots, with the help of workers.",
                ACCORD_VERSION},
               coordinator_table(settings), argc, argv);
  if (start.end) return *start.end;
  start_log("accord-coordinator", settings.log);
  for (const std::string& warning : start.warnings) spdlog::warn("{}", warning);
  return serve(settings);
}

}  // namespace
}  // namespace accord

int main(int argc, char** argv) {
  return accord::process_main("accord-coordinator", [&] { return accord::run(argc, argv); });
}
