#include "client/service_port.h"

#include <iostream>
#include <utility>

#include "client/option_values.h"
#include "common/transport/fleet/dds_fleet.h"

namespace accord {

void Patience::add_to(CLI::App& command, const std::string& help) {
  command.add_option("--patience", seconds, help)
      ->capture_default_str()
      ->check(seconds_within(0.1, 1e6));
}

std::chrono::nanoseconds Patience::duration() const {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(seconds));
}

std::unique_ptr<FleetClientPort> open_port_or_explain(const DdsOptions& dds, HeardPlans plans) {
  auto port = make_dds_fleet_client(dds, plans);
  if (port) return std::move(*port);
  std::cerr << "accord: " << port.error() << "\n";
  return nullptr;
}

void explain_no_service(const Patience& patience) {
  std::cerr << "accord: no service has answered within " << patience.seconds
            << " s; is a coordinator running in the same domain and cluster? \"accord doctor\" "
               "finds out\n";
}

}  // namespace accord
