// What every FleetServicePort does alike: checks and counts what goes and comes. Implementations
// carry it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/transport/fleet/fleet_port.h"

namespace accord {

// Not thread safe, as its interface.
class CheckedService : public FleetServicePort {
 public:
  std::optional<FleetRequest> take() final;
  void publish(const FleetNews& news) final;
  const FleetCounters& counters() const final { return counters_; }

 private:
  // The next request, if one has come; not checked.
  virtual std::optional<FleetRequest> do_take() = 0;
  // False: not sent. Requires: fleet_fault() of it is nullopt.
  virtual bool do_publish(const FleetNews& news) = 0;
  // How many of what came could not even be read.
  virtual std::uint64_t unreadable() const = 0;

  // What has gone and come, topic by topic; none where nobody counts.
  virtual FleetTraffic::Totals traffic() const { return {}; }

  void refuse(const FleetRequest& request, std::string fault);

  FleetCounters counters_;
  std::uint64_t beyond_limits_ = 0;
};

}  // namespace accord
