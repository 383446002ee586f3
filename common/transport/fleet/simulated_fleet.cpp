#include "common/transport/fleet/simulated_fleet.h"

#include <utility>

#include "common/transport/fleet/checked_service.h"
#include "common/transport/fleet/plan_pieces.h"
#include "common/transport/fleet/simulated_fleet_core.h"

namespace accord {
namespace {

class SimulatedService final : public CheckedService {
 public:
  SimulatedService(std::shared_ptr<SimulatedFleetCore> core, std::function<void()> wake)
      : core_(std::move(core)), self_(core_->serve(std::move(wake))) {}
  ~SimulatedService() override { core_->leave(self_); }

 private:
  std::optional<FleetRequest> do_take() override { return core_->take(*self_); }

  bool do_publish(const FleetNews& news) override {
    return std::visit([this](const auto& kind) { return send(kind); }, news);
  }
  template <typename News>
  bool send(const News& news) {
    return core_->publish(self_, news);
  }
  bool send(const FinishedPlan& plan) {
    const PlanPieces pieces(plan);
    bool sent = core_->publish(self_, pieces.outline());
    for (std::size_t robot = 0; robot < plan.plan.robots.size(); ++robot) {
      for (PathPiece& piece : pieces.of_robot(robot)) {
        sent = core_->publish(self_, std::move(piece)) && sent;
      }
    }
    return sent;
  }

  std::uint64_t unreadable() const override { return 0; }

  std::shared_ptr<SimulatedFleetCore> core_;
  std::shared_ptr<SimulatedFleetCore::Service> self_;
};

class SimulatedClient final : public AssemblingClient {
 public:
  SimulatedClient(std::shared_ptr<SimulatedFleetCore> core, std::chrono::nanoseconds patience,
                  HeardPlans plans)
      : AssemblingClient(patience, plans), core_(std::move(core)), self_(core_->join()) {}
  ~SimulatedClient() override { core_->leave(self_); }

  bool has_service() const override { return core_->has_service(); }

 private:
  bool do_send(const FleetRequest& request) override { return core_->send(request); }
  std::optional<FleetPart> do_take() override { return core_->take(*self_); }
  void do_wait(std::chrono::nanoseconds timeout) override { core_->wait(*self_, timeout); }
  std::uint64_t unreadable() const override { return 0; }

  std::shared_ptr<SimulatedFleetCore> core_;
  std::shared_ptr<SimulatedFleetCore::Client> self_;
};

}  // namespace

SimulatedFleet::SimulatedFleet(std::uint64_t seed, std::chrono::nanoseconds patience)
    : core_(std::make_shared<SimulatedFleetCore>(seed)), patience_(patience) {}

SimulatedFleet::~SimulatedFleet() = default;

std::unique_ptr<FleetServicePort> SimulatedFleet::serve(std::function<void()> wake) {
  return std::make_unique<SimulatedService>(core_, std::move(wake));
}

std::unique_ptr<FleetClientPort> SimulatedFleet::join(HeardPlans plans) {
  return std::make_unique<SimulatedClient>(core_, patience_, plans);
}

void SimulatedFleet::set_faults(const FleetFaults& faults) {
  core_->set_faults(faults);
}

void SimulatedFleet::kill_service() {
  core_->kill_service();
}

}  // namespace accord
