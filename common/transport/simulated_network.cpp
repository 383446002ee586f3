#include "common/transport/simulated_network.h"

#include "common/transport/simulated_core.h"

namespace accord {
namespace {

class SimulatedBus final : public Bus {
 public:
  SimulatedBus(std::shared_ptr<SimulatedCore> core, EndpointId self, Role role)
      : Bus(self, role), core_(std::move(core)) {}
  ~SimulatedBus() override { core_->leave(self()); }

 private:
  Published do_publish(EndpointId to, const Message& message) override {
    return core_->publish(self(), to, message);
  }
  std::optional<BusEvent> do_take() override { return core_->take(self()); }
  bool do_wait(Duration timeout) override { return core_->wait(self(), timeout); }
  void do_wake() override { core_->wake(self()); }

  std::shared_ptr<SimulatedCore> core_;
};

}  // namespace

SimulatedNetwork::SimulatedNetwork(std::uint64_t seed, const NetworkTimes& times)
    : core_(std::make_shared<SimulatedCore>(seed, times)) {}

SimulatedNetwork::~SimulatedNetwork() = default;

std::unique_ptr<Bus> SimulatedNetwork::join(Role role, std::uint32_t protocol,
                                            std::size_t capacity) {
  return std::make_unique<SimulatedBus>(core_, core_->join(role, protocol, capacity), role);
}

Bus::Duration SimulatedNetwork::now() const {
  return core_->now();
}

std::optional<Bus::Duration> SimulatedNetwork::next() const {
  return core_->next();
}

void SimulatedNetwork::advance_to(Bus::Duration time) {
  core_->advance_to(time);
}

void SimulatedNetwork::set_faults(const NetworkFaults& faults) {
  core_->set_faults(faults);
}

void SimulatedNetwork::cut(EndpointId a, EndpointId b) {
  core_->set_cut(a, b, true);
}

void SimulatedNetwork::heal(EndpointId a, EndpointId b) {
  core_->set_cut(a, b, false);
}

void SimulatedNetwork::kill(EndpointId endpoint) {
  core_->kill(endpoint);
}

void SimulatedNetwork::freeze(EndpointId endpoint) {
  core_->set_frozen(endpoint, true);
}

void SimulatedNetwork::thaw(EndpointId endpoint) {
  core_->set_frozen(endpoint, false);
}

}  // namespace accord
