// What every FleetClientPort does alike: checks what goes and comes, puts plans together, and asks
// for those that come with a gap; or gives their outlines, where outcomes are all that is wanted.
// Implementations carry parts.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "common/transport/fleet/fleet_port.h"
#include "common/transport/fleet/plan_assembly.h"
#include "common/transport/fleet/plan_parts.h"

namespace accord {

// Not thread safe, as its interface.
class AssemblingClient : public FleetClientPort {
 public:
  // Of plans that have begun to come, or of which this end knows that they are there.
  static constexpr std::chrono::milliseconds kPatience{200};

  bool send(const FleetRequest& request) final;
  std::optional<FleetNews> take() final;
  void wait(std::chrono::nanoseconds timeout) final;
  const FleetCounters& counters() const final { return counters_; }

 protected:
  explicit AssemblingClient(std::chrono::nanoseconds patience = kPatience,
                            HeardPlans plans = HeardPlans::kWhole)
      : wants_paths_(plans == HeardPlans::kWhole), assembly_(patience) {}

 private:
  // False: not sent. Requires: fleet_fault() of it is nullopt.
  virtual bool do_send(const FleetRequest& request) = 0;
  // The next part, if one has come; not checked.
  virtual std::optional<FleetPart> do_take() = 0;
  // Until do_take() may give something. May return early.
  virtual void do_wait(std::chrono::nanoseconds timeout) = 0;
  // How many of what came could not even be read.
  virtual std::uint64_t unreadable() const = 0;

  std::optional<FleetNews> news_of(FleetPart part);
  void ask_again();

  const bool wants_paths_;
  PlanAssembly assembly_;
  FleetCounters counters_;
  std::uint64_t beyond_limits_ = 0;
  bool drained_ = false;
};

}  // namespace accord
