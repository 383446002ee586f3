// What the commands that ask a service have in common beside where it is: how long to wait for it,
// and what to say where it is not there.
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "client/service_options.h"
#include "common/transport/fleet/fleet_port.h"

namespace accord {

struct Patience {
  double seconds = 10;

  // `help` says what it is for.
  void add_to(CLI::App& command, const std::string& help);
  std::chrono::nanoseconds duration() const;
};

// The port; null: explained, and the exit code is ExitCode::kNoService.
std::unique_ptr<FleetClientPort> open_port_or_explain(const DdsOptions& dds, HeardPlans plans);

void explain_no_service(const Patience& patience);

}  // namespace accord
