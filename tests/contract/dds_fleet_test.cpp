// The public topics over DDS keep the contract, within one process but through real transports.
#include <gtest/gtest.h>

#include <tuple>

#include "common/transport/fleet/dds_fleet.h"
#include "tests/contract/dds_world.h"
#include "tests/contract/fleet_contract.h"

namespace accord {
namespace {

using fleet_contract::Check;
using Transport = DdsOptions::Transport;

class DdsFleetWorld final : public fleet_contract::World {
 public:
  explicit DdsFleetWorld(DdsOptions options) : options_(std::move(options)) {}

  std::unique_ptr<FleetServicePort> serve(std::function<void()> wake) override {
    auto service = make_dds_fleet_service(options_, std::move(wake));
    if (!service) throw std::runtime_error(service.error());
    return std::move(*service);
  }
  std::unique_ptr<FleetClientPort> join() override {
    auto client = make_dds_fleet_client(options_);
    if (!client) throw std::runtime_error(client.error());
    return std::move(*client);
  }

 private:
  DdsOptions options_;
};

class DdsFleet : public testing::TestWithParam<std::tuple<Check, Transport>> {};

TEST_P(DdsFleet, KeepsTheContract) {
  DdsFleetWorld world(local_dds(std::get<Transport>(GetParam())));
  EXPECT_EQ(std::get<Check>(GetParam()).run(world), "");
}

INSTANTIATE_TEST_SUITE_P(Contract, DdsFleet,
                         testing::Combine(testing::ValuesIn(fleet_contract::checks()),
                                          testing::Values(Transport::kSharedMemory,
                                                          Transport::kUdp)),
                         [](const auto& param_info) {
                           const bool udp = std::get<1>(param_info.param) == Transport::kUdp;
                           return std::get<0>(param_info.param).name +
                                  (udp ? "OverUdp" : "OverSharedMemory");
                         });

}  // namespace
}  // namespace accord
